// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/Options.h"

#include "app/cli/NumberFrom.h"
#include "app/cli/StudyOptions.h"
#include "core/simulation/SceneCheck.h"

#include <charconv>
#include <map>
#include <memory>
#include <numbers>

namespace toile::cli {
namespace {

using batch::AvatarOptions;
using batch::ConvertOptions;
using batch::InspectOptions;
using batch::MeshOptions;
using batch::SewOptions;

constexpr double millimetre = 0.001;

/// An option in millimetres into a value in metres.
CLI::Option* addLength(CLI::App& command, const std::string& name, double& metres, const std::string& what) {
    return command.add_option_function<double>(
        name, [&metres](const double& value) { metres = value * millimetre; }, what);
}

CLI::Option* addSpacing(CLI::App& command, std::optional<double>& spacing) {
    return command
        .add_option_function<double>(
            "--spacing", [&spacing](const double& value) { spacing = value * millimetre; },
            "main spacing of every piece [mm]")
        ->check(numberFrom(0.1, 1000.0));
}

void addRule(CLI::App& command, std::optional<pattern::LineRule>& chosen) {
    const std::map<std::string, pattern::LineRule> rules{{"regular", pattern::LineRule::regular},
                                                         {"features", pattern::LineRule::features},
                                                         {"paper", pattern::LineRule::paper}};
    command
        .add_option_function<pattern::LineRule>(
            "--rule", [&chosen](const pattern::LineRule& rule) { chosen = rule; }, "how scan lines are chosen")
        ->transform(CLI::CheckedTransformer(rules));
}

void declareCheck(CLI::App& app, Chosen& chosen) {
    auto* command = app.add_subcommand("check", "print the problems of documents, one a line");
    auto files = std::make_shared<std::vector<std::string>>();
    command->add_option("FILE", *files, ".toile documents or patterns that can be imported")->required();
    command->callback([files, &chosen] { chosen = [files] { return batch::check(*files); }; });
}

void declareMesh(CLI::App& app, Chosen& chosen) {
    auto* command = app.add_subcommand("mesh", "mesh the pieces and report their quality");
    auto options = std::make_shared<MeshOptions>();
    command->add_option("FILE", options->file)->required();
    addSpacing(*command, options->spacing);
    addRule(*command, options->rule);
    const std::map<std::string, pattern::RegionBorder> borders{{"snap", pattern::RegionBorder::snap},
                                                               {"exact", pattern::RegionBorder::exact}};
    command
        ->add_option_function<pattern::RegionBorder>(
            "--border", [options](const pattern::RegionBorder& border) { options->border = border; },
            "what becomes of the borders of regions")
        ->transform(CLI::CheckedTransformer(borders));
    command->add_option("--piece", options->piece, "only the piece of this name or id");
    command->add_flag("!--no-regions", options->regions, "the main mesh alone");
    command->add_option("--repeat", options->repeat, "runs whose median time is reported")->check(CLI::Range(1, 1000));
    command->add_option("--out", options->out, "write the mesh: .obj, .svg or .png");
    command->add_option("--report", options->report, "write mesh.json");
    command->callback(
        [options, &chosen] { chosen = [options](std::stop_token stop) { return batch::mesh(*options, stop); }; });
}

void declareSew(CLI::App& app, Chosen& chosen) {
    auto* command = app.add_subcommand("sew", "sew the garment round its avatar and drape it");
    auto options = std::make_shared<SewOptions>();
    command->add_option("FILE", options->file)->required();
    command->add_option("--avatar", options->avatar, "a body instead of the document's");
    auto* spacing = addSpacing(*command, options->spacing);
    addRule(*command, options->rule);
    auto* seconds = command->add_option_function<double>(
        "--seconds", [options](const double& value) { options->seconds = value; }, "simulate just so long [s]");
    seconds->check(numberFrom(0.0, 3600.0));
    command->add_flag("--until-rest")
        ->description("simulate until the cloth is at rest (the default)")
        ->excludes(seconds);
    auto* refine = command->add_flag("--refine", options->refine,
                                     "sew on the document's own mesh first, and carry the drape over to --spacing");
    refine->needs(spacing)->excludes(seconds);
    auto* selfContact =
        command->add_flag("--self-contact", options->selfContact, "keep the cloth's layers apart, asked for or not");
    command->add_option("--limit", options->limit, "give up waiting for rest after so many simulated seconds [s]")
        ->check(numberFrom(0.1, 3600.0));
    command
        ->add_option("--time-limit", options->timeLimit,
                     "end after so many seconds of the clock on the wall, wherever the run is then [s]")
        ->check(numberFrom(0.001, 1e6));
    command
        ->add_option("--hold", options->hold,
                     "a garment without a neck goes on for so long after rest, to see whether it slides [s]")
        ->check(numberFrom(0.0, 3600.0))
        ->capture_default_str();
    auto* method = command->add_option("--method", options->method,
                                       "how time is integrated once the seams are closed; sewing itself is by xpbd");
    method->check(CLI::IsMember(batch::sewMethods()));
    command
        ->add_flag("--paper", options->paper,
                   "the 2002 paper end to end: its mesh, springs alone, a sewing force, explicit steps by regions")
        ->excludes(method)
        ->excludes(refine)
        ->excludes(selfContact);
    const auto isAuto = [](const std::string& text) { return std::string(text == "auto" ? "" : "only auto is known"); };
    command
        ->add_option_function<std::string>(
            "--arrange", [options](const std::string&) { options->arrange = true; },
            "auto: pieces that would start in the body are moved out of it (on another avatar they always are)")
        ->check(isAuto);
    command->add_flag("--strict", options->strict, "refuse a garment that starts in the body or in itself");
    command->add_option("--threads", options->threads, "threads to use at most; all cores by default")
        ->check(CLI::Range(1, 1024));
    command
        ->add_option_function<double>(
            "--memory",
            [options](const double& megabytes) { options->memory = static_cast<std::size_t>(1e6 * megabytes); },
            "megabytes that the simulation may take; what the machine can give by default")
        ->check(CLI::Range(1.0, 1e9));
    command->add_flag("--deterministic")->description("the same result whatever the number of threads; it always is");
    command
        ->add_option_function<double>(
            "--step", [options](const double& value) { options->step = value; }, "frame step [s]")
        ->check(numberFrom(simulation::shortestFrameStep, simulation::longestFrameStep));
    command
        ->add_option_function<std::string>(
            "--substeps",
            [options](const std::string& text) { options->substeps = text == "auto" ? 0 : std::stoi(text); },
            "substeps of a frame step, or auto")
        ->check([](const std::string& text) {
            int number = 0;
            const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
            const bool isOne = failure == std::errc() && end == text.data() + text.size();
            if (text == "auto" || (isOne && number >= 1 && number <= simulation::mostSubsteps)) return std::string();
            return fmt::format("\"{}\" is neither auto nor a whole number from 1 to {}", text,
                               simulation::mostSubsteps);
        });
    auto* checkpoint = command->add_option(
        "--checkpoint", options->checkpoint,
        "write where the simulation stands at the end, also when it is stopped (Ctrl+C, SIGTERM, SIGHUP, SIGPIPE)");
    command->add_option("--resume", options->resume, "go on from a checkpoint of the same garment, body and options")
        ->excludes(refine); // it stands on the fine mesh already
    auto* lift = command
                     ->add_option_function<double>(
                         "--lift-arms",
                         [options](const double& degrees) { options->liftArms = degrees * std::numbers::pi / 180; },
                         "when the garment is worn, lift the avatar's arms sideways by so much [degrees]")
                     ->check(numberFrom(-180.0, 180.0))
                     ->excludes(checkpoint); // it knows the avatar as it stood
    command->add_option("--lift-time", options->liftTime, "in so many seconds")
        ->needs(lift)
        ->check(numberFrom(0.01, 60.0));
    auto* motion =
        command
            ->add_option("--motion", options->motion,
                         "when the garment is worn, move the avatar through the poses in this folder: models "
                         "of it in the order of their names")
            ->excludes(lift)
            ->excludes(checkpoint);
    command->add_option("--motion-step", options->motionStep, "from pose to pose [s]")
        ->needs(motion)
        ->check(numberFrom(1e-4, 10.0));
    command->add_option("--out", options->out, "write the drape: .glb, .obj, .ply or .stl");
    command->add_option("--frames", options->frames,
                        "keep every frame step: a point cache (.pc2), or a folder for .obj files");
    command
        ->add_option("--picture", options->pictures,
                     "write a picture; front, back, left, right or top by the file's name; may be given again")
        ->delimiter(',')
        ->allow_extra_args(false); // a FILE behind it is not one more picture
    command->add_option("--report", options->report, "write sew.json");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback(
        [options, &chosen] { chosen = [options](std::stop_token stop) { return batch::sew(*options, stop); }; });
}

void declareAvatar(CLI::App& app, Chosen& chosen) {
    auto* command = app.add_subcommand("avatar", "compute a mannequin from measurements [mm]");
    auto options = std::make_shared<AvatarOptions>();
    body::Measurements& m = options->measurements;
    addLength(*command, "--height", m.height, "standing height");
    addLength(*command, "--bust", m.bust, "girth of the bust");
    addLength(*command, "--under-bust", m.underBust, "girth under the bust");
    addLength(*command, "--waist", m.waist, "girth of the waist");
    addLength(*command, "--hip", m.hip, "girth of the hip");
    addLength(*command, "--neck", m.neck, "girth of the neck");
    addLength(*command, "--biceps", m.biceps, "girth of the upper arm");
    addLength(*command, "--wrist", m.wrist, "girth of the wrist");
    addLength(*command, "--thigh", m.thigh, "girth of the thigh");
    addLength(*command, "--shoulder-width", m.shoulderWidth, "acromion to acromion");
    addLength(*command, "--nape-to-waist", m.napeToWaist, "nape to waist level");
    addLength(*command, "--bust-height", m.bustHeight, "side neck point to bust point");
    addLength(*command, "--arm", m.arm, "acromion to wrist");
    addLength(*command, "--inside-leg", m.insideLeg, "crotch to floor");
    command->add_option_function<double>(
        "--shoulder-slope", [&m](const double& degrees) { m.shoulderSlope = degrees * std::numbers::pi / 180; },
        "below the horizontal [degrees]");
    addLength(*command, "--edge", options->edge, "edges of the mesh, about");
    command->add_option("--out", options->out, "body file: .glb")->required();
    command->callback([options, &chosen] { chosen = [options] { return batch::avatar(*options); }; });
}

void declareInspect(CLI::App& app, Chosen& chosen) {
    auto* command = app.add_subcommand("inspect", "say what is in a file: pieces, seams, lengths, fabrics, bodies");
    auto options = std::make_shared<InspectOptions>();
    command->add_option("FILE", options->file)->required();
    command->add_flag("--json", options->json, "as JSON");
    command->callback([options, &chosen] { chosen = [options] { return batch::inspect(*options); }; });
}

void declareConvert(CLI::App& app, Chosen& chosen) {
    auto* command = app.add_subcommand("convert", "turn a pattern that can be imported into a .toile document");
    auto options = std::make_shared<ConvertOptions>();
    command->add_option("IN", options->in)->required();
    command->add_option("OUT", options->out)->required();
    command->callback([options, &chosen] { chosen = [options] { return batch::convert(*options); }; });
}

/// An empty value would pass for an option that was left out.
void refuseEmptyValues(CLI::App& command) {
    const auto isEmpty = [](const std::string& text) { return text.empty() ? "it is empty" : ""; };
    for (CLI::Option* option : command.get_options())
        if (option->get_items_expected_max() > 0) option->check(isEmpty);
    for (CLI::App* subcommand : command.get_subcommands({})) refuseEmptyValues(*subcommand);
}

} // namespace

void declareCommands(CLI::App& app, Chosen& chosen) {
    declareCheck(app, chosen);
    declareMesh(app, chosen);
    declareSew(app, chosen);
    declareAvatar(app, chosen);
    declareInspect(app, chosen);
    declareConvert(app, chosen);
    declareStudy(app, chosen);
    refuseEmptyValues(app);
}

} // namespace toile::cli
