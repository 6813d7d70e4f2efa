// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/FrameFiles.h"
#include "tests/Suite.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <cstring>
#include <fstream>

using namespace toile;

namespace {

/// One triangle.
Shared<simulation::FrameTopology> triangle() {
    simulation::FrameTopology topology;
    topology.pieces = {{"p1", "Front", 0, 3, 0, 1}};
    topology.material = {{0, 0}, {1, 0}, {0, 1}};
    topology.triangles = {{0, 1, 2}};
    topology.triangleRegion = {-1};
    return Shared<simulation::FrameTopology>(std::move(topology));
}

const std::vector<Vec3> low{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, high{{0, 0, 5}, {1, 0, 5}, {0, 1, 5.5}};

template <class Number>
Number numberAt(const std::string& bytes, std::size_t place) {
    Number number;
    std::memcpy(&number, bytes.data() + place, sizeof number);
    return number;
}

} // namespace

class tst_FrameFiles : public QObject {
    Q_OBJECT
private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }
    void thePointCacheIsAsItsFormatSays();
    void aCacheThatIsNotFinishedLeavesNothing();
    void aCacheLeavesItsNeighboursAlone();
    void aCacheReplacesTheTargetOfALink();
    void aFolderHoldsOneFileAFrame();
    void whatCannotBeWrittenIsSaid_data();
    void whatCannotBeWrittenIsSaid();

private:
    [[nodiscard]] std::filesystem::path in(const char* name) const { return folder_->filePath(name).toStdString(); }
    void put(const char* name) const { std::ofstream(in(name)) << "mine"; }
    std::unique_ptr<QTemporaryDir> folder_;
};

void tst_FrameFiles::thePointCacheIsAsItsFormatSays() {
    auto files = io::FrameFiles::create(in("cache.pc2"), triangle());
    QVERIFY(files);
    QVERIFY((*files)->add(low) && (*files)->add(high) && (*files)->finish());
    std::ifstream file(in("cache.pc2"), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    QCOMPARE(bytes.size(), std::size_t(32 + 2 * 3 * 12));
    QCOMPARE(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
    QCOMPARE(numberAt<std::int32_t>(bytes, 12), 1);
    QCOMPARE(numberAt<std::int32_t>(bytes, 16), 3);
    QCOMPARE(numberAt<float>(bytes, 20), 0.f);
    QCOMPARE(numberAt<float>(bytes, 24), 1.f);
    QCOMPARE(numberAt<std::int32_t>(bytes, 28), 2);
    QCOMPARE(numberAt<float>(bytes, 32 + 5 * 12 + 8), 5.5f); // z of the last point
}

void tst_FrameFiles::aCacheThatIsNotFinishedLeavesNothing() {
    {
        auto files = io::FrameFiles::create(in("cache.pc2"), triangle());
        QVERIFY(files && (*files)->add(low));
    }
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files | QDir::Hidden).size(), 0);
}

void tst_FrameFiles::aCacheLeavesItsNeighboursAlone() {
    put("cache.pc2.part");
    auto files = io::FrameFiles::create(in("cache.pc2"), triangle());
    QVERIFY(files && (*files)->add(low) && (*files)->finish());
    std::string kept;
    std::ifstream(in("cache.pc2.part")) >> kept;
    QCOMPARE(kept, std::string("mine"));
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
}

void tst_FrameFiles::aCacheReplacesTheTargetOfALink() {
    put("target.pc2");
    std::filesystem::create_symlink("target.pc2", in("link.pc2"));
    auto files = io::FrameFiles::create(in("link.pc2"), triangle());
    QVERIFY(files && (*files)->add(low) && (*files)->finish());
    QVERIFY(std::filesystem::is_symlink(in("link.pc2")));
    QCOMPARE(std::filesystem::file_size(in("target.pc2")), std::uintmax_t(32 + 3 * 12));
}

void tst_FrameFiles::aFolderHoldsOneFileAFrame() {
    auto files = io::FrameFiles::create(in("frames"), triangle());
    QVERIFY(files);
    QVERIFY((*files)->add(low) && (*files)->add(high) && (*files)->finish());
    QCOMPARE(QDir(folder_->filePath("frames")).entryList(QDir::Files),
             (QStringList{"frame-00000.obj", "frame-00001.obj"}));
}

void tst_FrameFiles::whatCannotBeWrittenIsSaid_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("said");
    QTest::newRow("a cache where there is no folder") << "no such folder/cache.pc2"
                                                      << "Cannot be written";
    QTest::newRow("a cache with a name too long") << QString(300, 'a') + ".pc2"
                                                  << "Cannot be written";
    QTest::newRow("a cache with a folder's name") << "folder.pc2"
                                                  << "it is not a regular file";
    QTest::newRow("a folder where there is none") << "no such folder/frames"
                                                  << "The folder cannot be made";
    QTest::newRow("a folder with a name too long") << QString(300, 'a') << "The folder cannot be made";
    QTest::newRow("a folder with a file's name") << "file"
                                                 << "The folder cannot be made: File exists.";
}

void tst_FrameFiles::whatCannotBeWrittenIsSaid() {
    QFETCH(QString, name);
    QFETCH(QString, said);
    put("file");
    std::filesystem::create_directory(in("folder.pc2"));
    const auto files = io::FrameFiles::create(folder_->filePath(name).toStdString(), triangle());
    QVERIFY(!files);
    QVERIFY2(QString::fromStdString(files.error().text).contains(said), files.error().text.c_str());
}

TOILE_TEST(tst_FrameFiles)
#include "tst_FrameFiles.moc"
