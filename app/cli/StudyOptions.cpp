// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/StudyOptions.h"

#include "app/batch/Commands.h"
#include "app/cli/NumberFrom.h"

#include <cmath>
#include <cstdio>
#include <memory>

namespace toile::cli {
namespace {

using batch::CasesOptions;
using batch::StorageOptions;
using batch::StudyOptions;

/// PIECE=LEFT,BOTTOM,RIGHT,TOP with parts of the piece's extent.
std::optional<study::FineBox> fineBoxOf(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0) return std::nullopt;
    study::FineBox box{.piece = text.substr(0, equals)};
    int read = 0;
    const std::string numbers = text.substr(equals + 1);
    if (std::sscanf(numbers.c_str(), "%lf,%lf,%lf,%lf%n", &box.left, &box.bottom, &box.right, &box.top, &read) != 4 ||
        read != static_cast<int>(numbers.size()))
        return std::nullopt;
    if (!std::isfinite(box.left + box.bottom + box.right + box.top)) return std::nullopt;
    return box;
}

void addFresh(CLI::App& command, bool& fresh) {
    command.add_flag("--fresh", fresh, "measure again what stands in the folder already; else the study goes on");
}

void declareStorage(CLI::App& study, Chosen& chosen) {
    auto* storage = study.add_subcommand("storage", "nodes, elements and bytes of a document's regions");
    auto options = std::make_shared<StorageOptions>();
    storage->add_option("FILE", options->file, "a document")->required();
    storage
        ->add_option_function<std::vector<std::string>>(
            "--fine",
            [options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options->fine.push_back(*fineBoxOf(text));
            },
            "PIECE=LEFT,BOTTOM,RIGHT,TOP: a part of its extent (0 to 1) at half its spacing, instead of the "
            "document's regions; may be given again")
        ->allow_extra_args(false)
        ->check([](const std::string& text) {
            return fineBoxOf(text) ? "" : "PIECE=LEFT,BOTTOM,RIGHT,TOP with four numbers is wanted";
        });
    storage->add_option("--out", options->out, "folder of report.md and results.jsonl")->required();
    storage->callback([options, &chosen] { chosen = [options] { return batch::studyStorage(*options); }; });
}

void declareValidation(CLI::App& study, Chosen& chosen) {
    auto* validation = study.add_subcommand("validation", "cases with known answers");
    auto options = std::make_shared<CasesOptions>();
    validation->add_option("--only", options->only, "numbers of cases, as V5,V13; all if none is named")
        ->delimiter(',');
    validation->add_option("--out", options->out, "folder of report.md and results.jsonl");
    validation->callback([options, &chosen] {
        chosen = [options](std::stop_token stop) { return batch::studyValidation(*options, stop); };
    });
}

void declareStability(CLI::App& study, Chosen& chosen) {
    auto* stability = study.add_subcommand("stability", "extreme inputs: bounded, or refused with a sentence");
    auto options = std::make_shared<CasesOptions>();
    stability->add_option("--only", options->only, "numbers of cases, as S1,S12; all if none is named")->delimiter(',');
    stability->add_flag("--quick", options->quick, "coarser and shorter, in about two minutes");
    stability->add_option("--out", options->out, "folder of report.md, results.jsonl and the map of S1");
    stability->callback([options, &chosen] {
        chosen = [options](std::stop_token stop) { return batch::studyStability(*options, stop); };
    });
}

void declareLean(CLI::App& study, Chosen& chosen) {
    auto* lean = study.add_subcommand("lean", "what parts of a step cost, and that they cost nothing where not needed");
    auto options = std::make_shared<StudyOptions>();
    lean->add_option("CASE", options->cases, "features, as self-contact, and documents; all features if none is named");
    lean->add_flag("--full,!--quick", options->full, "meshes of 10 mm; else of 20 mm");
    lean->add_option("--out", options->out, "folder of report.md and results.jsonl")->required();
    lean->add_option("--repetitions", options->repetitions, "of every run")->check(CLI::Range(1, 1000));
    lean->add_flag("--count", options->count, "count instructions by valgrind, too; takes minutes");
    addFresh(*lean, options->fresh);
    lean->add_flag("--quiet", options->quiet, "no progress");
    lean->callback(
        [options, &chosen] { chosen = [options](std::stop_token stop) { return batch::studyLean(*options, stop); }; });
}

void declareScenes(CLI::App& study, Chosen& chosen) {
    auto* scenes = study.add_subcommand("scenes", "scenes with a goal for error and cost, and what is seen of them");
    auto options = std::make_shared<StudyOptions>();
    options->full = true;
    scenes->add_option("NAME", options->cases,
                       "flap, hanging, stiff, ball, tunic, t-shirt, falling; all if none is named");
    scenes->add_flag("--full,!--quick", options->full, "without --quick also those that take minutes");
    scenes->add_option("--out", options->out, "folder of report.md and results.jsonl")->required();
    scenes->add_option("--repetitions", options->repetitions, "of every timed run")->check(CLI::Range(1, 1000));
    addFresh(*scenes, options->fresh);
    scenes->add_flag("--quiet", options->quiet, "no progress");
    scenes->callback([options, &chosen] {
        chosen = [options](std::stop_token stop) { return batch::studyScenes(*options, stop); };
    });
}

void declareCompare(CLI::App& study, Chosen& chosen) {
    auto* compare = study.add_subcommand("compare", "what got better or worse between two reports of one study");
    auto reports = std::make_shared<std::pair<std::string, std::string>>();
    compare->add_option("OLD", reports->first, "folder of a report, or its results.jsonl")->required();
    compare->add_option("NEW", reports->second)->required();
    compare->callback(
        [reports, &chosen] { chosen = [reports] { return batch::studyCompare(reports->first, reports->second); }; });
}

void declareAccuracy(CLI::App& study, Chosen& chosen) {
    auto* accuracy =
        study.add_subcommand("accuracy", "error against run time of the methods, on built-in scenes or on a garment");
    auto options = std::make_shared<StudyOptions>();
    accuracy->add_option(
        "CASE", options->cases,
        "oscillator, flap, two-corners, all if none is named; or one document, whose garment is draped");
    accuracy->add_flag("--full,!--quick", options->full,
                       "scenes: 32 cells a side and the stiffest cloth too, else 16; a garment: finer meshes, 16 "
                       "reference drapes");
    accuracy
        ->add_option_function<double>(
            "--within", [options](double mm) { options->within = 1e-3 * mm; },
            "name the cheapest setting by which every length of the garment is right within so much [mm]")
        ->check(numberFrom(1e-3, 1e3));
    accuracy->add_option("--out", options->out, "folder of report.md, results.jsonl and pictures")->required();
    addFresh(*accuracy, options->fresh);
    accuracy->add_flag("--quiet", options->quiet, "no progress");
    accuracy->callback([options, &chosen] {
        chosen = [options](std::stop_token stop) { return batch::studyAccuracy(*options, stop); };
    });
}

void declareRegions(CLI::App& study, Chosen& chosen) {
    auto* regions = study.add_subcommand("regions", "a document's regions against uniform meshes");
    auto options = std::make_shared<StudyOptions>();
    regions->add_option("FILE", options->cases, "a document with regions")->required()->expected(1);
    regions->add_flag("--full,!--quick", options->full,
                      "the reference is twice as fine as the finest region; else as fine as it");
    regions->add_option("--out", options->out, "folder of report.md and results.jsonl")->required();
    addFresh(*regions, options->fresh);
    regions->add_flag("--quiet", options->quiet, "no progress");
    regions->callback([options, &chosen] {
        chosen = [options](std::stop_token stop) { return batch::studyRegions(*options, stop); };
    });
}

} // namespace

void declareStudy(CLI::App& app, Chosen& chosen) {
    auto* study = app.add_subcommand("study", "measure how wrong results are, and what they cost");
    study->require_subcommand(1);
    declareAccuracy(*study, chosen);
    declareRegions(*study, chosen);
    declareStorage(*study, chosen);
    declareValidation(*study, chosen);
    declareStability(*study, chosen);
    declareLean(*study, chosen);
    declareScenes(*study, chosen);
    declareCompare(*study, chosen);
}

} // namespace toile::cli
