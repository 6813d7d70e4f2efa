// SPDX-License-Identifier: GPL-3.0-or-later
// Playing the simulation, and what comes back from it.
#include "ui/values/Units.h"
#include "ui/workbench/Workbench.h"

#include <QFileInfo>

namespace toile::ui {

void Workbench::play() {
    if (!parts_.simulation) return tell(tr("There is no simulation in this build."), true);
    if (bodyLoading_) playWhenReady_ = true;
    else parts_.simulation->play();
    follow();
}

void Workbench::pause() {
    playWhenReady_ = false;
    if (parts_.simulation) parts_.simulation->pause();
    follow();
}

void Workbench::step() {
    if (parts_.simulation) parts_.simulation->step();
    follow();
}

void Workbench::reset() {
    if (parts_.simulation) parts_.simulation->reset();
    follow();
}

void Workbench::finishAtRest(bool wanted) {
    if (parts_.simulation) parts_.simulation->finishAtRest(wanted);
    follow();
}

void Workbench::drapeWith(dynamics::Method method) {
    method_ = method;
    if (parts_.simulation) parts_.simulation->drapeWith(method);
    follow();
}

QString Workbench::whyMethodStays() const {
    return frame_ && frame_->bodyMoves ? tr("While the avatar moves, the method stays.") : QString();
}

/// Once, when statics has come to its end.
void Workbench::tellOfFinish(const simulation::Frame& frame) {
    if (frame_ && frame_->finish == frame.finish) return;
    const QString move = textOf(Quantity::length, frame.finishMove);
    QStringList lines;
    for (const Warning& warning : frame.warnings) lines << QString::fromStdString(warning.place + ": " + warning.text);
    if (frame.finish == simulation::Finish::found)
        lines << tr("In equilibrium: statics moved the cloth by %1 at most.").arg(move);
    else if (frame.finish == simulation::Finish::notFound)
        lines
            << tr("At rest, but statics found no equilibrium; what came nearest is shown, %1 away at most.").arg(move);
    else return;
    tell(lines.join(QLatin1Char('\n')), !frame.warnings.empty());
}

/// What stops the simulation is told until it goes on; what does not, as long as any other problem.
void Workbench::tellOfProblem(const QString& why) {
    tell(why, true);
    if (!isPlaying()) complaint_ = Complaint::ofSimulation;
}

void Workbench::hold(std::vector<simulation::Grip> grips) {
    if (parts_.simulation) parts_.simulation->hold(std::move(grips));
    follow();
}

void Workbench::saveCheckpoint(const QString& path) {
    checkpointPath_ = path;
    if (parts_.simulation) parts_.simulation->askForCheckpoint();
    follow();
}

void Workbench::takeCheckpoint() {
    const auto checkpoint = parts_.simulation->takeCheckpoint();
    if (!checkpoint) return;
    const auto written = checkpoint->and_then(
        [this](const simulation::Checkpoint& c) { return parts_.writeCheckpoint(checkpointPath_.toStdString(), c); });
    if (written) tell(tr("Saved %1").arg(QFileInfo(checkpointPath_).fileName()));
    else tell(QString::fromStdString(toString(written.error())), true);
}

Result<void> Workbench::resumeFrom(const QString& path) {
    auto read = parts_.readCheckpoint(path.toStdString());
    if (!read) return tl::unexpected(read.error());
    if (bodyLoading_) resumeWhenReady_ = std::move(*read);
    else if (parts_.simulation) parts_.simulation->resume(std::move(*read));
    follow();
    return {};
}

void Workbench::follow() {
    if (!parts_.simulation) return;
    frames_.start();
    pollFrame();
}

void Workbench::pollFrame() {
    if (!parts_.simulation) return;
    if (!parts_.simulation->isBusy()) frames_.stop(); // asked before the frame is taken: the last one is not missed
    takeCheckpoint();
    if (auto frame = parts_.simulation->takeFrame(); frame && frame->generation == generation_ && scene_) {
        if (frame->message.empty()) takeBack(Complaint::ofSimulation);
        else tellOfProblem(QString::fromStdString(frame->message));
        tellOfFinish(*frame);
        const bool wasBuilt = frame->message.empty(); // else the garment as it was stays in view
        if (!frame->positions.empty()) frame_ = std::move(*frame);
        else if (wasBuilt) frame_.reset();
        Q_EMIT frameArrived();
    }
    if (const bool playing = parts_.simulation->isPlaying(); playing != wasPlaying_) {
        wasPlaying_ = playing;
        Q_EMIT playingChanged();
    }
}

} // namespace toile::ui
