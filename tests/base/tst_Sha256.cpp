// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Sha256.h"
#include "tests/Suite.h"

#include <QTest>
#include <string_view>

using namespace toile;

class tst_Sha256 : public QObject {
    Q_OBJECT
private slots:
    void knowsTheStandardsExamples_data();
    void knowsTheStandardsExamples();
};

void tst_Sha256::knowsTheStandardsExamples_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("digest");
    QTest::newRow("empty") << QByteArray()
                           << QByteArray("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    QTest::newRow("abc") << QByteArray("abc")
                         << QByteArray("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    QTest::newRow("two blocks") << QByteArray("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")
                                << QByteArray("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

void tst_Sha256::knowsTheStandardsExamples() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, digest);
    const std::string_view view(text.constData(), static_cast<std::size_t>(text.size()));
    QCOMPARE(QByteArray::fromStdString(sha256(std::as_bytes(std::span(view)))), digest);
}

TOILE_TEST(tst_Sha256)
#include "tst_Sha256.moc"
