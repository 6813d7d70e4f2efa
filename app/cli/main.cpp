// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/BuildFacts.h"
#include "app/batch/Console.h"
#include "app/cli/Options.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <fmt/ranges.h>
#include <new>
#include <thread>

namespace {

volatile std::sig_atomic_t stopIsWanted = 0;

extern "C" void wantStop(int signal) {
    if (signal == SIGINT && stopIsWanted != 0) std::_Exit(130);
    stopIsWanted = 1;
}

/// Ctrl+C, being told to end, and the end of the terminal or of who reads the output ask the work to stop; a Ctrl+C
/// after that ends the program at once.
std::stop_source stopOnSignals() {
    std::signal(SIGINT, wantStop);
    std::signal(SIGTERM, wantStop);
    for (const int signal : {SIGHUP, SIGPIPE})
        if (std::signal(signal, wantStop) == SIG_IGN) std::signal(signal, SIG_IGN); // as who began it wants, nohup too
    static std::stop_source source;
    std::thread([] { // a signal handler may not touch a stop source
        while (stopIsWanted == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        source.request_stop();
    })
        .detach();
    return source;
}

/// The command whose own command was not understood, or is missing; absent where none is.
const CLI::App* wantingCommand(const CLI::App& app) {
    if (!app.get_subcommands().empty()) return wantingCommand(*app.get_subcommands().front());
    return app.get_require_subcommand_min() > 0 ? &app : nullptr;
}

/// CLI11 would only say that a command is missing. Empty where none was given.
std::string unknownCommand(const CLI::App& app) {
    const CLI::App* const wanting = wantingCommand(app);
    if (!wanting || wanting->remaining().empty()) return {};
    const std::string word = wanting->remaining().front();
    if (word.starts_with('-')) return fmt::format("There is no option \"{}\" of {}.", word, wanting->get_name());
    std::vector<std::string> names;
    for (const CLI::App* command : wanting->get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return fmt::format("There is no command \"{}\" of {}; there are {}.", word, wanting->get_name(),
                       fmt::join(names, ", "));
}

int run(int argc, char** argv) {
    CLI::App app("Toile without a window: check, mesh, sew and convert garment patterns.", "toile-cli");
    app.require_subcommand(1);
    app.set_version_flag("--version", toile::batch::versionText("toile-cli"));
    toile::cli::Chosen chosen;
    toile::cli::declareCommands(app, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::RequiredError& problem) {
        const std::string unknown = unknownCommand(app);
        if (unknown.empty()) (void)app.exit(problem);
        else toile::batch::printError({toile::ErrorCode::invalidInput, unknown, {}});
        return toile::batch::usageWrong;
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? toile::batch::done : toile::batch::usageWrong;
    }
    if (const auto* const atOnce = std::get_if<std::function<int()>>(&chosen)) return (*atOnce)();
    return std::get<std::function<int(std::stop_token)>>(chosen)(stopOnSignals().get_token());
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
