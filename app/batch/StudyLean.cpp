// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/Instructions.h"
#include "app/batch/Opening.h"
#include "app/batch/RecordBook.h"
#include "app/batch/StudyFolder.h"
#include "core/io/DocumentFile.h"
#include "core/study/lean/Records.h"
#include "core/study/lean/Report.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::batch {
namespace {

using namespace study::lean;

Result<Feature> garmentIn(const std::string& file) {
    const auto document = io::readDocument(file);
    if (!document) return tl::unexpected(document.error());
    auto opened = openScene(document->document, file);
    if (!opened) return tl::unexpected(opened.error());
    return garmentFeature(std::filesystem::path(file).stem().string(), opened->scene);
}

/// Features by name and documents by file, in the order in which they were named; all features, where none is.
Result<std::vector<Feature>> chosenFeatures(const StudyOptions& options) {
    std::vector<Feature> all = allFeatures(!options.full);
    if (options.cases.empty()) return all;
    std::vector<Feature> chosen;
    std::error_code ignored; // what cannot be looked at is no document
    for (const std::string& name : options.cases) {
        const auto found = std::ranges::find(all, name, &Feature::name);
        if (found != all.end()) {
            chosen.push_back(*found);
        } else if (std::filesystem::exists(name, ignored)) {
            auto garment = garmentIn(name);
            if (!garment) return tl::unexpected(garment.error());
            chosen.push_back(std::move(*garment));
        } else {
            std::vector<std::string> names;
            for (const Feature& feature : all) names.push_back(feature.name);
            return fail(ErrorCode::notFound, fmt::format("\"{}\" is neither a document nor a feature; there are {}.",
                                                         name, fmt::join(names, ", ")));
        }
    }
    return chosen;
}

std::string commandOf(const StudyOptions& options) {
    std::string command = "toile-cli study lean";
    for (const std::string& name : options.cases)
        command += name.find(' ') == std::string::npos ? ' ' + name : " \"" + name + '"';
    if (options.repetitions > 0) command += fmt::format(" --repetitions {}", options.repetitions);
    if (options.count) command += " --count";
    return fmt::format("{} --{} --out {}", command, options.full ? "full" : "quick", options.out);
}

/// Instructions of the frames of every variant, in order; none where they are not asked for.
Result<std::vector<double>> instructionsOfAll(const StudyOptions& options, const std::vector<Feature>& features) {
    if (!options.count) return {};
    const std::string folder = options.out + "/counted";
    if (auto made = madeFolder(folder); !made) return tl::unexpected(made.error());
    std::vector<std::string> arguments{"study", "lean"};
    arguments.insert(arguments.end(), options.cases.begin(), options.cases.end());
    for (const char* word : {options.full ? "--full" : "--quick", "--repetitions", "1", "--fresh", "--quiet", "--out"})
        arguments.emplace_back(word);
    arguments.push_back(folder);
    auto counts = instructionsOf(arguments, countedStepsName, folder);
    std::error_code ignored; // at worst a folder stays behind
    std::filesystem::remove_all(folder, ignored);
    std::size_t variants = 0;
    for (const Feature& feature : features) variants += feature.variants.size();
    if (counts && counts->size() != variants)
        return fail(ErrorCode::unsupported,
                    fmt::format("valgrind counted {} of {} runs: it did not find them by their name.", counts->size(),
                                variants));
    return counts;
}

Result<std::vector<FeatureResult>> run(const StudyOptions& options, std::stop_token stop) {
    const auto features = chosenFeatures(options);
    if (!features) return tl::unexpected(features.error());
    if (auto made = madeFolder(options.out); !made) return tl::unexpected(made.error());
    const study::Circumstances circumstances = circumstancesOf(commandOf(options));
    auto book = RecordBook::opened(std::filesystem::path(options.out) / "results.jsonl", circumstances, options.fresh);
    if (!book) return tl::unexpected(book.error());
    ProgressBar bar(options.quiet);
    const auto instructions = instructionsOfAll(options, *features);
    if (!instructions) return tl::unexpected(instructions.error());
    LeanSettings settings{.counted = options.count};
    if (options.repetitions > 0) settings.repetitions = options.repetitions;
    std::size_t variants = 0; // so far
    std::vector<FeatureResult> results;
    for (const Feature& feature : *features) {
        const Progress progress = bar.progress(results.size(), features->size());
        auto result = book->part(
            keysOf(feature, settings), settings.repetitions,
            [&](const auto& known) { return resultFrom(feature, known); },
            [&] {
                auto run = studied(feature, settings, stop, progress);
                if (run && settings.counted)
                    addInstructions(*run, feature, std::span(*instructions).subspan(variants, feature.variants.size()));
                return run;
            },
            [&](const FeatureResult& run) { return recordsOf(run, circumstances); });
        if (!result) return tl::unexpected(result.error());
        variants += feature.variants.size();
        results.push_back(std::move(*result));
    }
    fmt::print("{}", book->standingText());
    if (auto written = writeReport(options.out, leanText(results, circumstances), book->records()); !written)
        return tl::unexpected(written.error());
    return results;
}

} // namespace

int studyLean(const StudyOptions& options, std::stop_token stop) {
    const auto results = run(options, stop);
    if (!results) {
        printError(results.error());
        return inputWrong;
    }
    fmt::print("{}\n{}/report.md\n", summaryOf(*results), options.out);
    return std::ranges::all_of(*results, passes) ? done : goalMissed;
}

} // namespace toile::batch
