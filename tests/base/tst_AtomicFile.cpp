// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AtomicFile.h"
#include "core/base/RegularFile.h"
#include "tests/Suite.h"

#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <unistd.h>

using namespace toile;
namespace fs = std::filesystem;

class tst_AtomicFile : public QObject {
    Q_OBJECT
private slots:
    void whatIsWrittenIsRead();
    void anExistingFileIsReplacedAndKeepsItsPermissions();
    void aWriteProtectedFileIsNotReplaced();
    void aLinkKeepsPointingAtItsTarget();
    void nothingIsLeftBehindWhenTheFolderDoesNotExist();
    void aFolderIsNotOverwritten();
    void whetherItCouldBeWrittenIsToldWithoutWriting();
    void foldersPipesAndLongFilesAreNotRead();

private:
    QTemporaryDir folder;
    [[nodiscard]] fs::path at(const char* name) const { return fs::path(folder.path().toStdString()) / name; }
    [[nodiscard]] long entries() const {
        return std::distance(fs::directory_iterator(folder.path().toStdString()), fs::directory_iterator());
    }
};

void tst_AtomicFile::whatIsWrittenIsRead() {
    const std::string bytes("a\0b\xff\n", 5);
    QVERIFY(writeFileAtomically(at("plain"), bytes));
    QCOMPARE(*readRegularFile(at("plain"), 100), bytes);
    QCOMPARE(entries(), 1L); // no neighbour is left
}

void tst_AtomicFile::anExistingFileIsReplacedAndKeepsItsPermissions() {
    QVERIFY(writeFileAtomically(at("plain"), "old and long"));
    QCOMPARE(::chmod(at("plain").c_str(), 0640), 0);
    QVERIFY(writeFileAtomically(at("plain"), "new"));
    QCOMPARE(*readRegularFile(at("plain"), 100), std::string("new"));
    struct stat facts {};
    QCOMPARE(::stat(at("plain").c_str(), &facts), 0);
    QCOMPARE(int(facts.st_mode & 0777), 0640);
}

void tst_AtomicFile::aWriteProtectedFileIsNotReplaced() {
    QVERIFY(writeFileAtomically(at("protected"), "mine"));
    QCOMPARE(::chmod(at("protected").c_str(), 0444), 0);
    const long before = entries();
    const auto written = writeFileAtomically(at("protected"), "yours"); // root is refused as well
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::io);
    QCOMPARE(*readRegularFile(at("protected"), 100), std::string("mine"));
    QCOMPARE(entries(), before);
}

void tst_AtomicFile::aLinkKeepsPointingAtItsTarget() {
    fs::create_symlink("target", at("link"));
    QVERIFY(writeFileAtomically(at("link"), "through"));
    QVERIFY(fs::is_symlink(at("link")));
    QCOMPARE(*readRegularFile(at("target"), 100), std::string("through"));
}

void tst_AtomicFile::nothingIsLeftBehindWhenTheFolderDoesNotExist() {
    const auto written = writeFileAtomically(at("nowhere") / "x", "y");
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::io);
    QVERIFY(!fs::exists(at("nowhere")));
}

void tst_AtomicFile::aFolderIsNotOverwritten() {
    fs::create_directory(at("folder"));
    const long before = entries();
    QVERIFY(!writeFileAtomically(at("folder"), "y"));
    QVERIFY(fs::is_directory(at("folder")));
    QCOMPARE(entries(), before);
}

void tst_AtomicFile::whetherItCouldBeWrittenIsToldWithoutWriting() {
    QVERIFY(writeFileAtomically(at("old"), "old"));
    fs::create_directory(at("folder"));
    const long before = entries();
    QVERIFY(checkWritable(at("new")));
    QVERIFY(checkWritable(at("old")));
    QCOMPARE(*readRegularFile(at("old"), 100), std::string("old"));
    QVERIFY(!checkWritable(at("folder")));
    QVERIFY(!checkWritable(at("no such folder/new")));
    QVERIFY(!checkWritable("/proc/new"));
    QCOMPARE(entries(), before);
}

void tst_AtomicFile::foldersPipesAndLongFilesAreNotRead() {
    QCOMPARE(readRegularFile(at("missing"), 9).error().code, ErrorCode::notFound);
    QVERIFY(!readRegularFile(folder.path().toStdString(), 1 << 20));
    QCOMPARE(::mkfifo(at("pipe").c_str(), 0600), 0);
    QVERIFY(!readRegularFile(at("pipe"), 9)); // and this line is reached
    QVERIFY(writeFileAtomically(at("long"), "0123456789"));
    QCOMPARE(readRegularFile(at("long"), 9).error().code, ErrorCode::tooLarge);
}

TOILE_TEST(tst_AtomicFile)
#include "tst_AtomicFile.moc"
