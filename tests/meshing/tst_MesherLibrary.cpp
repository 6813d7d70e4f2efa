// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

/// The mesher as a library for other programs: built and installed without the rest of Toile, and used by the example.
class tst_MesherLibrary : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void itInstallsWithoutTheRest();
    void theExampleRunsWithIt();
    void thePageShowsTheExample();

private:
    /// Standard output of a command; an empty array with a warning where it failed.
    static QByteArray run(const QString& program, const QStringList& arguments);
    [[nodiscard]] QString in(const char* name) const { return folder_.filePath(name); }
    /// Kept, so that only what changed is compiled again.
    const QDir folder_{qEnvironmentVariable("TOILE_BINARY_DIR", ".") + "/mesher-library"};
    const QString source_ = qEnvironmentVariable("TOILE_SOURCE_DIR", ".");
};

QByteArray tst_MesherLibrary::run(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    process.waitForFinished(-1);
    const QByteArray said = process.readAll();
    if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0) return said;
    qWarning("%s %s: %s", qPrintable(program), qPrintable(arguments.join(' ')), said.constData());
    return {};
}

void tst_MesherLibrary::initTestCase() {
    QVERIFY(QDir(in("installed")).removeRecursively());
}

void tst_MesherLibrary::itInstallsWithoutTheRest() {
    QVERIFY(!run(TOILE_CMAKE, {"-G", TOILE_GENERATOR, "-S", source_, "-B", in("build"), "-DTOILE_MESHER=ON",
                               "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_COMPILER=" TOILE_COMPILER,
                               "-DCMAKE_INSTALL_LIBDIR=lib", "-DCMAKE_INSTALL_PREFIX=" + in("installed")})
                 .isEmpty());
    QVERIFY(!run(TOILE_CMAKE, {"--build", in("build")}).isEmpty());
    QVERIFY(!run(TOILE_CMAKE, {"--install", in("build")}).isEmpty());
    QVERIFY(QFile::exists(in("installed/include/toile/core/meshing/GarmentMesh.h")));
    const QStringList libraries = QDir(in("installed/lib")).entryList({"*.a"}, QDir::Files, QDir::Name);
    QCOMPARE(libraries, (QStringList{"libtoile_base.a", "libtoile_geometry.a", "libtoile_meshing.a"}));
}

void tst_MesherLibrary::theExampleRunsWithIt() {
    QVERIFY(!run(TOILE_CMAKE, {"-G", TOILE_GENERATOR, "-S", source_ + "/examples/mesher", "-B", in("example"),
                               "-DCMAKE_CXX_COMPILER=" TOILE_COMPILER, "-DCMAKE_PREFIX_PATH=" + in("installed")})
                 .isEmpty());
    QVERIFY(!run(TOILE_CMAKE, {"--build", in("example")}).isEmpty());
    const QByteArray said = run(in("example/mesher-example"), {});
    QCOMPARE(said.count("sew node "),
             12 + 36 + 1); // 0.24 m below the notch at 20 mm, 0.36 m above it at the shoulder's 10 mm
    QVERIFY2(said.contains("Back: ") && said.contains("Front: "), said.constData());
}

/// Every line of the page's program stands in the example, in one piece.
void tst_MesherLibrary::thePageShowsTheExample() {
    const auto linesOf = [](const QString& text) {
        QStringList lines;
        for (const QString& line : text.split('\n'))
            if (!line.trimmed().isEmpty()) lines += line.simplified();
        return lines.join('\n');
    };
    QFile page(source_ + "/docs/how-to/use-the-mesher.md"), example(source_ + "/examples/mesher/main.cpp");
    QVERIFY(page.open(QIODevice::ReadOnly) && example.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(page.readAll());
    const QString begin = "```cpp\n";
    const qsizetype from = text.indexOf(begin) + begin.size(), to = text.indexOf("```", from);
    QVERIFY(from > begin.size() && to > from);
    QVERIFY(linesOf(QString::fromUtf8(example.readAll())).contains(linesOf(text.mid(from, to - from))));
}

TOILE_TEST(tst_MesherLibrary, QCoreApplication)
#include "tst_MesherLibrary.moc"
