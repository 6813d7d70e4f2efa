// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ToileFile.h"
#include "tests/Suite.h"

#include "tests/io/SampleDocument.h"

#include <QFile>
#include <QTest>
#include <map>
#include <set>

using namespace toile;

/// docs/formats/toile.schema.json says what the program writes: the same keys at every place.
class tst_ToileSchema : public QObject {
    Q_OBJECT
private slots:
    void everyKeyWrittenIsInTheSchema();
    void everyKeyOfTheSchemaIsWritten();
    void everyRequiredKeyIsAskedFor_data();
    void everyRequiredKeyIsAskedFor();
};

namespace {

/// Names of objects of the schema ("" is the document) and the keys they have.
using Keys = std::map<std::string, std::set<std::string>>;

const Json& schema() {
    static const Json json = [] {
        QFile file(qEnvironmentVariable("TOILE_SOURCE_DIR") + "/docs/formats/toile.schema.json");
        if (!file.open(QIODevice::ReadOnly)) qFatal("no schema");
        return *parseJson(file.readAll().toStdString());
    }();
    return json;
}

/// The name behind "#/$defs/NAME"; empty when this is no reference.
std::string referenced(const Json& type) {
    const Json* ref = type.find("$ref");
    return ref ? ref->asString()->substr(std::string("#/$defs/").size()) : std::string();
}

void collectWritten(const Json& value, const std::string& name, Keys& keys);

void collectMember(const Json& value, const Json& type, Keys& keys) {
    if (const Json* items = type.find("items"); items && value.asArray()) {
        for (const Json& item : *value.asArray()) collectMember(item, *items, keys);
    } else if (value.asObject()) collectWritten(value, referenced(type), keys);
}

void collectWritten(const Json& value, const std::string& name, Keys& keys) {
    const Json& type = name.empty() ? schema() : *schema().find("$defs")->find(name);
    for (const auto& [key, member] : *value.asObject()) {
        keys[name].insert(key);
        if (const Json* memberType = type.find("properties")->find(key)) collectMember(member, *memberType, keys);
    }
}

Keys written() {
    Keys keys;
    collectWritten(*parseJson(io::toileText(tests::everyField())), "", keys);
    return keys;
}

Keys described() {
    Keys keys;
    const auto add = [&](const std::string& name, const Json& type) {
        if (const Json* properties = type.find("properties"))
            for (const auto& member : *properties->asObject()) keys[name].insert(member.first);
    };
    add("", schema());
    for (const auto& [name, type] : *schema().find("$defs")->asObject()) add(name, type);
    return keys;
}

void compare(const Keys& some, const Keys& all) {
    for (const auto& [name, keys] : some)
        for (const std::string& key : keys)
            QVERIFY2(all.contains(name) && all.at(name).contains(key), (name + "." + key).c_str());
}

/// The text without the first member of this name.
std::string without(const std::string& text, const std::string& key) {
    const auto at = text.find("\"" + key + "\":");
    return std::string(text).replace(at, key.size() + 2, "\"x-" + key + "\"");
}

} // namespace

void tst_ToileSchema::everyKeyWrittenIsInTheSchema() {
    compare(written(), described());
}
void tst_ToileSchema::everyKeyOfTheSchemaIsWritten() {
    compare(described(), written());
}

void tst_ToileSchema::everyRequiredKeyIsAskedFor_data() {
    QTest::addColumn<QString>("key");
    // Keys whose first appearance in the sample is in the object that requires them.
    for (const char* key :
         {"format", "version", "arealDensity", "biasBending", "vertices", "edges", "x", "y", "shape", "control1",
          "position", "points", "outline", "matrix", "axis", "sideA", "sideB", "strain", "vertex"})
        QTest::newRow(key) << key;
}

void tst_ToileSchema::everyRequiredKeyIsAskedFor() {
    QFETCH(QString, key);
    const auto document = io::documentFromText(without(io::toileText(tests::everyField()), key.toStdString()));
    QVERIFY(!document);
    QVERIFY(document.error().text.find("\"" + key.toStdString() + "\" is missing") != std::string::npos);
}

TOILE_TEST(tst_ToileSchema)
#include "tst_ToileSchema.moc"
