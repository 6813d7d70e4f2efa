// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace {

using namespace toile::suite;

/// By name. Made by the first entry: the order in which files enter theirs is the linker's.
std::map<std::string, Run>& tests() {
    static std::map<std::string, Run> entered;
    return entered;
}

} // namespace

toile::suite::Entry::Entry(const char* name, Run run) {
    if (tests().emplace(name, run).second) return;
    std::fprintf(stderr, "Two tests are called %s.\n", name);
    std::abort();
}

/// The first argument is the test's name; the others are QtTest's.
int main(int argc, char** argv) {
    if (argc < 2) {
        for (const auto& [name, run] : tests()) std::puts(name.c_str());
        return 2;
    }
    const auto test = tests().find(argv[1]);
    if (test != tests().end()) return test->second(argc - 1, argv + 1);
    std::fprintf(stderr, "%s has no test %s; without arguments it lists what it has.\n", argv[0], argv[1]);
    return 2;
}
