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

volatile std::sig_atomic_t stopIsWanted = 0;

extern "C" void wantStop(int signal) {
    if (signal == SIGINT && stopIsWanted != 0) std::_Exit(130);
    stopIsWanted = 1;
}

/// Ctrl+C, being told to end, and the end of the terminal ask the work to stop; a Ctrl+C after that ends the program at
/// once.
std::stop_source stopOnSignals() {
    std::signal(SIGINT, wantStop);
    std::signal(SIGTERM, wantStop);
    if (std::signal(SIGHUP, wantStop) == SIG_IGN) std::signal(SIGHUP, SIG_IGN); // as nohup wants it
    static std::stop_source source;
    std::thread([] { // a signal handler may not touch a stop source
        while (stopIsWanted == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        source.request_stop();
    })
        .detach();
    return source;
}

int run(int argc, char** argv) {
    CLI::App app("Toile without a window: check, mesh, sew and convert garment patterns.", "toile-cli");
    app.require_subcommand(1);
    app.set_version_flag("--version", toile::batch::versionText("toile-cli"));
    const std::stop_source stop = stopOnSignals();
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
