// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/cli/Program.h"

#include <QFileInfo>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace toile;

/// What a program says that it was built from: looked up by every build, in a repository made for the test.
class tst_Commit : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void aCommitIsNamed();
    void whatDiffersFromTheCommitIsTold();
    void nothingIsWrittenWhileItStaysTheSame();
    void withoutARepositoryThereIsNone();

private:
    /// Standard output without its line end; a command that fails ends the test.
    QString said(const QString& program, const QStringList& arguments) const {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(program, arguments);
        if (!process.waitForFinished() || process.exitCode() != 0)
            qFatal("%s %s: %s", qPrintable(program), qPrintable(arguments.join(' ')),
                   process.readAllStandardError().constData());
        return QString::fromUtf8(process.readAllStandardOutput()).trimmed();
    }
    QString git(const QStringList& arguments) const {
        return said("git", QStringList{"-c", "user.name=Test", "-c", "user.email=test@example.org"} + arguments);
    }
    void write(const QString& name, const QByteArray& content) const {
        const QFileInfo at(folder_.filePath(name));
        QFile file(at.filePath());
        if (!QDir().mkpath(at.path()) || !file.open(QIODevice::WriteOnly) || file.write(content) < 0)
            qFatal("a test writes its file");
    }
    QString commit(const QString& source = "source") const {
        const QString script = qEnvironmentVariable("TOILE_SOURCE_DIR") + "/cmake/WriteCommit.cmake";
        said(TOILE_CMAKE, {"-DSOURCE=" + folder_.filePath(source), "-DTEMPLATE=" + folder_.filePath("template"),
                           "-DOUTPUT=" + folder_.filePath("output"), "-P", script});
        return QString::fromUtf8(contentOf(folder_.filePath("output"))).trimmed();
    }
    QString head() const { return git({"-C", "source", "rev-parse", "--short", "HEAD"}); }

    QTemporaryDir folder_;
};

void tst_Commit::initTestCase() {
    if (QStandardPaths::findExecutable("git").isEmpty()) QSKIP("NOT RUN: needs git");
    write("template", "@TOILE_COMMIT@");
    write("source/core/a.cpp", "one");
    write("source/docs/page.md", "one");
    git({"init", "-q", "source"});
    git({"-C", "source", "add", "."});
    git({"-C", "source", "commit", "-qm", "First"});
}

void tst_Commit::aCommitIsNamed() {
    const QString first = commit();
    QCOMPARE(first, head());
    git({"-C", "source", "commit", "--allow-empty", "-qm", "Second"});
    QCOMPARE(commit(), head());
    QVERIFY(commit() != first);
}

void tst_Commit::whatDiffersFromTheCommitIsTold() {
    write("source/core/a.cpp", "two");
    const QString two = commit();
    QVERIFY2(two.startsWith(head() + "-dirty-"), qPrintable(two));
    QCOMPARE(commit(), two);
    write("source/core/a.cpp", "three");
    QVERIFY(commit().startsWith(head() + "-dirty-") && commit() != two);
    write("source/core/a.cpp", "one");
    QCOMPARE(commit(), head());
    write("source/core/b.cpp", "new");
    const QString added = commit();
    QVERIFY(added.startsWith(head() + "-dirty-"));
    write("source/core/b.cpp", "newer");
    QVERIFY(commit().startsWith(head() + "-dirty-") && commit() != added);
    QVERIFY(QFile::remove(folder_.filePath("source/core/b.cpp")));
    write("source/docs/page.md", "two");
    QCOMPARE(commit(), head()); // it is not of the program
}

void tst_Commit::nothingIsWrittenWhileItStaysTheSame() {
    const QString text = commit();
    QFile file(folder_.filePath("output"));
    const QDateTime before(QDate(2000, 1, 1), QTime(0, 0));
    QVERIFY(file.open(QIODevice::ReadWrite) && file.setFileTime(before, QFileDevice::FileModificationTime));
    file.close();
    QCOMPARE(commit(), text);
    QCOMPARE(QFileInfo(file.fileName()).lastModified(), before);
}

void tst_Commit::withoutARepositoryThereIsNone() {
    write("plain/core/a.cpp", "one");
    QCOMPARE(commit("plain"), QString());
}

TOILE_TEST(tst_Commit)
#include "tst_Commit.moc"
