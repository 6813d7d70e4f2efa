// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Mannequin.h"
#include "core/pattern/Pattern.h"
#include "core/study/Storage.h"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace toile::batch {

/// The commands of toile-cli as functions: options in, exit status out (Console.h). Results go to stdout and files,
/// errors to stderr.

[[nodiscard]] int check(const std::vector<std::string>& files);

struct MeshOptions {
    std::string file;
    std::optional<double> spacing; ///< [m]
    std::optional<pattern::LineRule> rule;
    std::optional<pattern::RegionBorder> border;
    std::string piece;   ///< only this one; empty = all
    bool regions = true; ///< false = the main mesh alone
    int repeat = 1;      ///< runs whose median time is reported
    std::string out, report;
};
[[nodiscard]] int mesh(const MeshOptions& options, std::stop_token stop);

struct SewOptions {
    std::string file, avatar;
    std::optional<double> spacing; ///< [m]
    std::optional<pattern::LineRule> rule;
    std::optional<double> seconds;     ///< [s]; absent = until rest
    bool refine = false;               ///< sews on the document's own mesh first
    bool selfContact = false;          ///< also where the document does not ask for it
    double limit = 20;                 ///< [s]
    double hold = 10;                  ///< after rest, of garments without a neck opening [s]
    std::optional<double> timeLimit;   ///< by the clock on the wall, after which the run ends wherever it is [s]
    std::optional<double> step;        ///< frame step [s]
    std::optional<int> substeps;       ///< 0 = chosen from the mesh; absent = as the document says
    std::string method = "xpbd";       ///< a name of sewMethods()
    bool paper = false;                ///< the method of the 2002 paper end to end
    bool arrange = false;              ///< pieces that would start in the body are moved out of it
    bool strict = false;               ///< refuses a start that overlaps the body or itself
    int threads = 0;                   ///< 0 = one for each core
    std::optional<std::size_t> memory; ///< that the simulation may take [B]; absent = what the machine can give
    std::string out, report;
    std::string resume;     ///< checkpoint to go on from; empty = from the start
    std::string checkpoint; ///< written at the end, also of a run that is stopped; empty = none
    std::string frames;     ///< folder or .pc2 for every frame step; empty = none
    double liftArms = 0;    ///< when the garment is worn [rad]; 0 = not
    double liftTime = 1;    ///< in which they are lifted [s]
    std::string motion;     ///< folder of poses of the avatar, gone through when the garment is worn; empty = none
    double motionStep = 1.0 / 30; ///< from pose to pose [s]
    std::vector<std::string> pictures;
    bool quiet = false;
};
[[nodiscard]] int sew(const SewOptions& options, std::stop_token stop);
/// "static", and the names of dynamics::allMethods().
[[nodiscard]] const std::vector<std::string>& sewMethods();

struct AvatarOptions {
    body::Measurements measurements;
    double edge = 0.0115; ///< of the mesh [m]
    std::string out;
};
[[nodiscard]] int avatar(const AvatarOptions& options);

struct StudyOptions {
    std::vector<std::string> cases; ///< scenes or features by name, empty = all; or documents
    bool full = false;              ///< finer and longer
    int repetitions = 0;            ///< of every run of lean and scenes; 0 = as many as the study takes
    bool count = false;             ///< instructions of lean, by valgrind
    bool fresh = false;             ///< measures again what stands in the folder already
    std::optional<double> within;   ///< of accuracy of a document: the error to suggest a setting for [m]
    std::string out;                ///< folder of the report
    bool quiet = false;
};
/// Error against run time of the methods on the built-in scenes, or of drapes of a document's garment.
[[nodiscard]] int studyAccuracy(const StudyOptions& options, std::stop_token stop);
/// A document's regions against uniform meshes.
[[nodiscard]] int studyRegions(const StudyOptions& options, std::stop_token stop);

/// What parts of a step cost, and that they cost nothing where a scene does not need them. Cases are features by name,
/// or documents.
[[nodiscard]] int studyLean(const StudyOptions& options, std::stop_token stop);

/// Scenes that have a goal for error and cost; cases are their names.
[[nodiscard]] int studyScenes(const StudyOptions& options, std::stop_token stop);

/// What differs between two reports of one study: folders, or their results.jsonl. goalMissed where something got
/// worse.
[[nodiscard]] int studyCompare(const std::string& before, const std::string& after);

struct StorageOptions {
    std::string file;
    std::vector<study::FineBox> fine; ///< instead of the document's regions; empty = those
    std::string out;                  ///< folder of the report
};
/// What a document's regions save: nodes, elements and bytes against uniform meshes.
[[nodiscard]] int studyStorage(const StorageOptions& options);

struct CasesOptions {
    std::vector<std::string> only; ///< numbers of cases; empty = all
    bool quick = false;            ///< of stability: coarser and shorter
    std::string out;               ///< folder of the report; empty = only printed
};
/// Cases with known answers.
[[nodiscard]] int studyValidation(const CasesOptions& options, std::stop_token stop);
/// Extreme inputs: bounded, or refused with a sentence.
[[nodiscard]] int studyStability(const CasesOptions& options, std::stop_token stop);

struct InspectOptions {
    std::string file;
    bool json = false;
};
[[nodiscard]] int inspect(const InspectOptions& options);

struct ConvertOptions {
    std::string in, out;
};
[[nodiscard]] int convert(const ConvertOptions& options);

} // namespace toile::batch
