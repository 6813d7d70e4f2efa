// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Json.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;

class tst_Json : public QObject {
    Q_OBJECT
private slots:
    void valuesKnowTheirLine();
    void writingAndReadingChangesNothing();
    void anErrorNamesFileAndLine();
    void aKeyGivenTwiceIsRefused();
    void anObjectMayHaveManyKeys();
    void deepNestingIsRefused();
};

void tst_Json::valuesKnowTheirLine() {
    const auto json = parseJson("{\n \"a\": 1,\n \"b\": [\n  2\n ],\n \"c\": 3\n}\n");
    QVERIFY(json);
    QCOMPARE(json->find("a")->line(), 2);
    QCOMPARE(json->find("b")->line(), 3);
    QCOMPARE(json->find("b")->asArray()->front().line(), 4); // a number before a line end
    QCOMPARE(json->find("c")->line(), 6);
}

void tst_Json::writingAndReadingChangesNothing() {
    Json json;
    json.set("number", 0.1).set("text", "a \"b\" \\ \n \u00e9").set("list", Json(Json::Array{1, 2.5, nullptr, true}));
    json.set("empty", Json(Json::Object{})).set("deep", Json(Json::Array{Json(Json::Array{1, 2})}));
    const auto again = parseJson(toText(json));
    QVERIFY(again);
    QVERIFY(*again == json);
    QVERIFY(*parseJson(toLine(json)) == json);
    QVERIFY(toLine(json).find('\n') == std::string::npos);
}

void tst_Json::anErrorNamesFileAndLine() {
    const auto json = parseJson("{\n \"a\": 1,\n \"b\" 2\n}", "x.toile");
    QVERIFY(!json);
    QCOMPARE(json.error().place.file, std::string("x.toile"));
    QCOMPARE(json.error().place.line, 3);
}

void tst_Json::aKeyGivenTwiceIsRefused() {
    QVERIFY(!parseJson("{\"a\": 1, \"a\": 2}"));
}

void tst_Json::anObjectMayHaveManyKeys() {
    // Looking through all before it for each would take minutes. The inner object is searched for itself.
    std::string text = "{\"inner\": {\"k1\": 1}";
    for (int i = 0; i < 200'000; ++i) text += ",\"k" + std::to_string(i) + "\": " + std::to_string(i);
    const auto many = parseJson(text + "}");
    QVERIFY2(many, many ? "" : many.error().text.c_str());
    QCOMPARE(many->asObject()->size(), std::size_t(200'001));
    QCOMPARE(*many->find("k199999")->asNumber(), 199999.0);
    for (const char* again : {"k0", "k31", "k199999", "inner"}) {
        const auto twice = parseJson(text + ",\"" + again + "\": 0}");
        QVERIFY(!twice);
        QCOMPARE(twice.error().text, "the key \"" + std::string(again) + "\" is given twice.");
    }
}

void tst_Json::deepNestingIsRefused() {
    QVERIFY(!parseJson(std::string(100000, '[')));
    QVERIFY(parseJson("[[[]]]"));
}

TOILE_TEST(tst_Json)
#include "tst_Json.moc"
