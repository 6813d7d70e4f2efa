// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

/// The tests of a room are one program, which is told the name of the one to run.
namespace toile::suite {

/// Runs a test with the arguments that a program of its own would get. @return the status that program would end with
using Run = int (*)(int argc, char** argv);

/// Enters a test into the program's list before main() begins.
struct Entry {
    Entry(const char* name, Run run);
};

/// In the place of an application, for a test that needs none.
struct NoApplication {
    NoApplication(int&, char**) {}
    void setAttribute(Qt::ApplicationAttribute) {}
};

/// What main() of QTEST_MAIN does.
template <class Test, class Application = NoApplication>
int run(int argc, char** argv) {
    QTest::Internal::callInitMain<Test>();
    Application application(argc, argv);
    application.setAttribute(Qt::AA_Use96Dpi);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace toile::suite

/// Stands where QTEST_MAIN would, with the application the test needs, if any:
///     TOILE_TEST(tst_Refine, QCoreApplication)
#define TOILE_TEST(Test, ...)                                                                                          \
    static const toile::suite::Entry Test##Entry(#Test, [](int argc, char** argv) {                                    \
        QTEST_SET_MAIN_SOURCE_PATH                                                                                     \
        return toile::suite::run<Test __VA_OPT__(, ) __VA_ARGS__>(argc, argv);                                         \
    });
