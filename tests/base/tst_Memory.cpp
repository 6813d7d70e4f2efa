// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Memory.h"
#include "tests/Suite.h"

#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <fstream>
#include <limits>

using namespace toile;
namespace fs = std::filesystem;

class tst_Memory : public QObject {
    Q_OBJECT

private slots:
    void ofThisMachineIsSomeAndNotAll() {
        QVERIFY(availableMemory() > 1'000'000);
        QVERIFY(availableMemory() < std::numeric_limits<std::size_t>::max());
    }

    void theLeastThatIsKnownCounts_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("outer");
        QTest::addColumn<QString>("inner");
        QTest::addColumn<qulonglong>("available");
        const qulonglong nothing = std::numeric_limits<std::size_t>::max();
        QTest::newRow("nothing is known") << ""
                                          << ""
                                          << "" << nothing;
        QTest::newRow("the machine's") << "MemTotal: 9 kB\nMemAvailable:   5 kB\n"
                                       << "max"
                                       << "max" << 5120ull;
        QTest::newRow("its group's, with files it can do without") << "MemAvailable: 100 kB\n"
                                                                   << "max"
                                                                   << "10000" << 10000ull - (3000 - 1000);
        QTest::newRow("that of the group around it") << "MemAvailable: 100 kB\n"
                                                     << "7000"
                                                     << "10000" << 5000ull;
        QTest::newRow("a group that has taken more than it may") << "MemAvailable: 100 kB\n"
                                                                 << "1500"
                                                                 << "max" << 0ull;
    }
    void theLeastThatIsKnownCounts() {
        QFETCH(QString, machine);
        QFETCH(QString, outer);
        QFETCH(QString, inner);
        QFETCH(qulonglong, available);
        const QTemporaryDir folder;
        const fs::path root = folder.path().toStdString();
        const auto put = [&](const char* name, const std::string& text) {
            fs::create_directories((root / name).parent_path());
            std::ofstream(root / name) << text;
        };
        if (!machine.isEmpty()) put("proc/meminfo", machine.toStdString());
        put("proc/self/cgroup", "1:name=other:/elsewhere\n0::/outer/inner\n");
        for (const auto& [group, limit] :
             {std::pair("sys/fs/cgroup/outer/", outer), std::pair("sys/fs/cgroup/outer/inner/", inner)}) {
            if (limit.isEmpty()) continue;
            put((std::string(group) + "memory.max").c_str(), limit.toStdString());
            put((std::string(group) + "memory.current").c_str(), "3000");
            put((std::string(group) + "memory.stat").c_str(), "anon 2000\ninactive_file 1000\n");
        }
        QCOMPARE(availableMemory(root), static_cast<std::size_t>(available));
    }
};

TOILE_TEST(tst_Memory)
#include "tst_Memory.moc"
