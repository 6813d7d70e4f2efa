// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/BuildFacts.h"
#include "app/batch/Console.h"
#include "app/cli/Options.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <thread>

namespace {

/// Ctrl+C asks the work to stop; a second one ends the program at once.
std::stop_source stopOnInterrupt() {
    static std::stop_source source;
    static volatile std::sig_atomic_t interrupts = 0;
    std::signal(SIGINT, [](int) {
        interrupts = interrupts + 1;
        if (interrupts > 1) std::_Exit(130);
    });
    std::thread([] { // a signal handler may not touch a stop source
        while (interrupts == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        source.request_stop();
    })
        .detach();
    return source;
}

int run(int argc, char** argv) {
    CLI::App app("Toile without a window: check, mesh, sew and convert garment patterns.", "toile-cli");
    app.require_subcommand(1);
    app.set_version_flag("--version", toile::batch::versionText("toile-cli"));
    const std::stop_source stop = stopOnInterrupt();
    std::function<int()> chosen;
    toile::cli::declareCommands(app, stop.get_token(), chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? toile::batch::done : toile::batch::usageWrong;
    }
    return chosen();
}

} // namespace

/// What is thrown ends here, not in an abort, so that half-written files are taken away on the way.
int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("There is not enough memory for this: choose a larger spacing, or allow more.\n", stderr);
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "The work cannot go on, by a mistake of the program: %s.\n", problem.what());
    }
    return toile::batch::inputWrong;
}
