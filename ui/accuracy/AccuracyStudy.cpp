// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/accuracy/AccuracyStudy.h"

#include "core/base/Contracts.h"
#include "core/study/EachPiece.h"
#include "core/study/GarmentReport.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::ui {
namespace {

pattern::Pattern meshOf(const pattern::Pattern& drawn, const study::GarmentSetup& setup) {
    return setup.regions ? study::coarser(drawn, setup.factor) : study::uniformCoarser(drawn, setup.factor);
}

/// The drawn mesh and all others that the plan tries.
std::vector<pattern::Pattern> meshesOf(const pattern::Pattern& drawn, const study::GarmentPlan& plan) {
    std::vector<pattern::Pattern> meshes{drawn};
    for (const study::GarmentSetup& setup : plan.setups)
        if (pattern::Pattern mesh = meshOf(drawn, setup); std::ranges::find(meshes, mesh) == meshes.end())
            meshes.push_back(std::move(mesh));
    return meshes;
}

/// The pattern with spacings and refinements of another that has the same pieces.
pattern::Pattern withSpacingsOf(const pattern::Pattern& pattern, const pattern::Pattern& other) {
    std::size_t index = 0;
    return study::eachPiece(pattern, [&](pattern::Piece& piece) {
        const pattern::Piece& from = *other.pieces[index++];
        piece.spacing = from.spacing;
        for (std::size_t r = 0; r < piece.regions.size(); ++r) piece.regions[r].refinement = from.regions[r].refinement;
    });
}

} // namespace

AccuracyStudy::AccuracyStudy(Workbench& workbench, AccuracyParts parts, QObject* parent)
    : QObject(parent), workbench_(workbench), parts_(std::move(parts)) {
    connect(&workbench, &Workbench::documentChanged, this, &AccuracyStudy::changed);
    connect(&workbench, &Workbench::bodyChanged, this, &AccuracyStudy::changed, Qt::QueuedConnection);
}

AccuracyStudy::~AccuracyStudy() {
    stop_.request_stop();
    works_.clear();
}

void AccuracyStudy::start() {
    if (isRunning()) return;
    expects(parts_.study && parts_.circumstances, "a study");
    problem_.clear();
    const std::optional<simulation::Scene>& scene = workbench_.scene();
    if (!scene || scene->pattern.pieces.empty() || workbench_.isReadingBody()) {
        problem_ = workbench_.isReadingBody() ? tr("The body is still being read.")
                                              : tr("There is no garment to be measured.");
        Q_EMIT changed();
        return;
    }
    const study::GarmentPlan plan = study::garmentPlan(scene->pattern, true);
    timeLeft_.emplace(plan);
    fraction_ = 0;
    doing_.clear();
    clock_.start();
    stop_ = {};
    const QFileInfo file(workbench_.path());
    const std::string name = workbench_.path().isEmpty() ? "untitled" : file.completeBaseName().toStdString();
    onThread([this, number = ++number_, name, scene = *scene, plan, command = command(), parts = parts_,
              stop = stop_.get_token()] {
        const auto tell = [&](double fraction, const std::string& what) {
            QMetaObject::invokeMethod(this, [this, number, fraction, what] {
                if (number == number_ && isRunning()) begin(fraction, what);
            });
        };
        const study::Circumstances circumstances = parts.circumstances(command);
        auto result = parts.study(name, scene, plan, stop, tell).map([&](study::GarmentAccuracy accuracy) {
            return StudiedGarment{std::move(accuracy), circumstances, scene, meshesOf(scene.pattern, plan)};
        });
        QMetaObject::invokeMethod(this, [this, number, result = std::move(result)]() mutable {
            if (number == number_ && isRunning()) finish(std::move(result));
        });
    });
    Q_EMIT changed();
}

void AccuracyStudy::cancel() {
    stop_.request_stop();
    timeLeft_.reset();
    Q_EMIT changed();
}

void AccuracyStudy::begin(double fraction, const std::string& what) {
    fraction_ = fraction;
    doing_ = what;
    timeLeft_->begin(static_cast<int>(std::lround(fraction * timeLeft_->goes())), 1e-3 * clock_.elapsed());
    Q_EMIT progressed();
}

void AccuracyStudy::finish(Result<StudiedGarment> result) {
    timeLeft_.reset();
    if (result) {
        result_ = std::move(*result);
        ++resultNumber_;
    } else {
        problem_ = QString::fromStdString(toString(result.error()));
    }
    Q_EMIT changed();
}

std::optional<double> AccuracyStudy::secondsLeft() const {
    return timeLeft_ ? timeLeft_->at(1e-3 * clock_.elapsed()) : std::nullopt;
}

bool AccuracyStudy::isStale() const {
    if (!result_) return false;
    if (!workbench_.scene() || workbench_.isReadingBody()) return true;
    simulation::Scene now = *workbench_.scene();
    return std::ranges::none_of(result_->meshes, [&](const pattern::Pattern& mesh) {
        simulation::Scene tried = result_->scene;
        tried.pattern = mesh;
        return tried == now;
    });
}

std::optional<document::Document> AccuracyStudy::withMeshOf(const study::GarmentRun& run) const {
    expects(result_ && !isStale(), "a study of the garment as it is");
    document::Document next = workbench_.document();
    next.pattern = withSpacingsOf(next.pattern, meshOf(result_->scene.pattern, run.setup));
    return next == workbench_.document() ? std::nullopt : std::optional(std::move(next));
}

/// That makes the report again; of what is not in a file it can only say so.
std::string AccuracyStudy::command() const {
    const bool inFile = !workbench_.path().isEmpty() && !workbench_.isModified();
    const std::string file = workbench_.path().isEmpty() ? "untitled.toile" : workbench_.path().toStdString();
    return fmt::format("toile-cli study accuracy {} --quick{}", file,
                       inFile ? "" : " (as it was in the window, not saved)");
}

QString AccuracyStudy::text(const std::optional<double>& within) const {
    return result_ ? QString::fromStdString(study::garmentText(result_->accuracy, within, result_->circumstances))
                   : QString();
}

void AccuracyStudy::save(const QString& folder, const std::optional<double>& within) {
    if (!result_) return;
    onThread([this, folder, within, result = *result_, write = parts_.write] {
        const auto written = write(folder.toStdString(), result.accuracy, within, result.circumstances);
        QMetaObject::invokeMethod(this, [this, folder, written] {
            if (written) Q_EMIT saved(folder);
            else Q_EMIT notSaved(QString::fromStdString(toString(written.error())));
        });
    });
}

void AccuracyStudy::onThread(std::function<void()> work) {
    dropOver();
    Work& next = works_.emplace_back();
    next.thread = std::jthread([&over = next.over, work = std::move(work)] {
        work();
        over = true;
    });
}

void AccuracyStudy::dropOver() {
    std::erase_if(works_, [](const Work& work) { return work.over.load(); });
}

} // namespace toile::ui
