// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/Workbench.h"

#include "core/document/DocumentEdits.h"
#include "ui/values/Units.h"

#include <QDir>
#include <QFileInfo>

#include <utility>

namespace toile::ui {
namespace {

constexpr std::chrono::milliseconds framePeriod{16};

/// What mesh and simulation depend on: the same for documents that differ in looks only.
simulation::Scene essence(simulation::Scene scene) {
    for (Shared<pattern::Piece>& shared : scene.pattern.pieces) {
        if (shared->tablePosition == Vec2{}) continue;
        pattern::Piece piece = *shared;
        piece.tablePosition = {};
        shared = Shared<pattern::Piece>(std::move(piece));
    }
    return scene;
}

/// Where the document's avatar lies: its path is relative to the document's file.
QString avatarPath(const std::string& avatar, const QString& documentPath) {
    const QString file = QString::fromStdString(avatar);
    if (file.isEmpty() || QDir::isAbsolutePath(file) || documentPath.isEmpty()) return file;
    return QDir::cleanPath(QFileInfo(documentPath).absoluteDir().filePath(file));
}

/// How the document names a file: relative to its own where it has one.
std::string avatarName(const QString& file, const QString& documentPath) {
    const QString absolute = QFileInfo(file).absoluteFilePath();
    if (documentPath.isEmpty()) return absolute.toStdString();
    return QFileInfo(documentPath).absoluteDir().relativeFilePath(absolute).toStdString();
}

} // namespace

Workbench::Workbench(WorkbenchParts parts, QObject* parent)
    : QObject(parent), parts_(std::move(parts)), preview_(parts_.mesh) {
    if (!parts_.recoveryFolder.isEmpty()) journal_.emplace(parts_.recoveryFolder, parts_.write);
    connect(&preview_, &MeshPreview::meshed, this, [this](const MeshedPattern& result) {
        if (result.generation != patternGeneration_) return; // a newer pattern is being meshed
        meshed_ = result;
        Q_EMIT meshChanged();
    });
    connect(&preview_, &MeshPreview::failed, this, [this](quint64 generation, const QString& why) {
        if (generation != patternGeneration_) return;
        meshed_ = {generation, {}, {}};
        Q_EMIT meshChanged();
        tell(why, true);
    });
    frames_.setInterval(framePeriod);
    connect(&frames_, &QTimer::timeout, this, &Workbench::pollFrame);
    recovery_.setSingleShot(true);
    recovery_.setInterval(parts_.recoveryDelay);
    connect(&recovery_, &QTimer::timeout, this, &Workbench::record);
    startNew();
}

Workbench::~Workbench() = default;

void Workbench::take(const Effect& effect) {
    if (effect.edit) apply(*effect.edit);
    if (effect.endsMerge) history_.endMerge();
    if (effect.selection) select(*effect.selection);
    if (!effect.message.isEmpty()) tell(effect.message, effect.refused);
}

void Workbench::apply(const Edit& edit) {
    const bool wasModified = isModified();
    history_.push(edit.name.toStdString(), edit.after, edit.mergeKey);
    documentMoved();
    if (journal_) recovery_.start();
    if (isModified() != wasModified) Q_EMIT fileChanged();
}

void Workbench::select(const Selection& selection) {
    const Selection kept = existing(selection, document().pattern);
    if (kept == selection_) return;
    selection_ = kept;
    Q_EMIT selectionChanged();
}

void Workbench::undo() {
    if (!history_.canUndo()) return;
    history_.undo();
    documentMoved();
    if (journal_) recovery_.start();
    Q_EMIT fileChanged();
}

void Workbench::redo() {
    if (!history_.canRedo()) return;
    history_.redo();
    documentMoved();
    if (journal_) recovery_.start();
    Q_EMIT fileChanged();
}

void Workbench::startNew() {
    document::Document empty;
    material::Fabric fabric;
    fabric.id = material::FabricId("f1");
    fabric.name = tr("Cotton").toStdString();
    fabric.source = tr("Values of the order of a cotton poplin, not measured.").toStdString();
    empty.pattern.fabrics.push_back(Shared<material::Fabric>(std::move(fabric)));
    empty.nextId = 2;
    startFrom(std::move(empty), {}, false);
}

Result<void> Workbench::open(const QString& path) {
    auto read = parts_.read(path.toStdString());
    if (!read) return tl::unexpected(read.error());
    const bool ours = path.endsWith(QLatin1String(".toile"), Qt::CaseInsensitive);
    startFrom(std::move(*read), ours ? QFileInfo(path).absoluteFilePath() : QString(), !ours);
    return {};
}

void Workbench::startFrom(document::Document document, const QString& path, bool modified) {
    path_ = path;
    history_ = modified ? document::History() : document::History(document);
    if (modified) history_.push((path.isEmpty() ? tr("Import") : tr("Recover")).toStdString(), std::move(document));
    if (journal_) journal_->clear();
    recovery_.stop();
    pause();
    resumeWhenReady_.reset();
    scene_.reset();
    resetNext_ = true;
    selection_.clear();
    frame_.reset();
    documentMoved();
    Q_EMIT selectionChanged();
    Q_EMIT fileChanged();
    Q_EMIT frameArrived(); // there is none: the old garment goes from the view
    Q_EMIT documentReplaced();
}

Result<void> Workbench::openCopy(const QString& path) {
    auto read = parts_.read(path.toStdString());
    if (!read) return tl::unexpected(read.error());
    read->avatarFile = avatarPath(read->avatarFile, QFileInfo(path).absoluteFilePath()).toStdString();
    startFrom(std::move(*read), {}, false);
    return {};
}

Result<void> Workbench::recover(const Journal::Leftover& leftover) {
    auto read = parts_.read(leftover.file.toStdString());
    if (!read) return tl::unexpected(read.error());
    startFrom(std::move(*read), leftover.path, true);
    record(); // under our own name, before the other one goes
    Journal::discard(leftover);
    return {};
}

Result<void> Workbench::saveAs(const QString& path) {
    document::Document toWrite = document();
    if (!toWrite.avatarFile.empty()) // the same body, named from the new place
        toWrite.avatarFile = avatarName(avatarPath(toWrite.avatarFile, path_), path);
    if (auto written = parts_.write(path.toStdString(), toWrite); !written) return written;
    path_ = QFileInfo(path).absoluteFilePath();
    if (!(toWrite == document())) history_.push(tr("Save as").toStdString(), std::move(toWrite));
    history_.markSaved();
    if (journal_) journal_->clear();
    recovery_.stop();
    Q_EMIT fileChanged();
    return {};
}

void Workbench::importAvatar(const QString& path) {
    apply({tr("Import avatar"), document::withAvatar(document(), avatarName(path, path_))});
}

void Workbench::removeAvatar() {
    apply({tr("Remove avatar"), document::withAvatar(document(), {})});
}

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

/// Once, when statics has come to its end.
void Workbench::tellOfFinish(const simulation::Frame& frame) {
    if (frame_ && frame_->finish == frame.finish) return;
    const QString move = textOf(Quantity::length, frame.finishMove);
    if (frame.finish == simulation::Finish::found)
        tell(tr("In equilibrium: statics moved the cloth by %1 at most.").arg(move));
    if (frame.finish == simulation::Finish::notFound)
        tell(tr("At rest, but statics found no equilibrium; what came nearest is shown, %1 away at most.").arg(move));
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
        if (!frame->message.empty()) tell(QString::fromStdString(frame->message), true);
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

void Workbench::tell(const QString& message, bool isProblem) {
    Q_EMIT messageChanged(message, isProblem);
}

/// The document is another one: everything that follows from it is made anew.
void Workbench::documentMoved() {
    flat_ = flattened(document().pattern);
    const Selection kept = existing(selection_, document().pattern);
    const bool lostSome = kept != selection_;
    selection_ = kept;
    loadBody();
    handOver();
    Q_EMIT documentChanged();
    if (lostSome) Q_EMIT selectionChanged();
}

/// Reads the document's body on a thread of its own; until it is there the simulation is not handed anything new.
void Workbench::loadBody() {
    const QString file = avatarPath(document().avatarFile, path_);
    if (file == bodyFile_) return;
    bodyFile_ = file;
    bodyLoading_ = !file.isEmpty() && parts_.readBody;
    if (!bodyLoading_) {
        body_.reset();
        Q_EMIT bodyChanged();
        return;
    }
    bodyThread_ = std::jthread([this, file, read = parts_.readBody] {
        auto body = read(file.toStdString());
        QMetaObject::invokeMethod(this, [this, file, body = std::move(body)] { takeBody(file, body); });
    });
}

void Workbench::takeBody(const QString& file, Result<body::Body> body) {
    if (file != bodyFile_) return; // another one is wanted by now
    bodyLoading_ = false;
    body_.reset();
    if (body) body_ = Shared<body::Body>(std::move(*body));
    else tell(QString::fromStdString(toString(body.error())), true);
    Q_EMIT bodyChanged();
    handOver();
    if (auto checkpoint = std::exchange(resumeWhenReady_, std::nullopt); checkpoint && parts_.simulation)
        parts_.simulation->resume(std::move(*checkpoint));
    if (std::exchange(playWhenReady_, false)) play();
}

void Workbench::handOver() {
    simulation::Scene scene = essence(document::sceneOf(document(), body_));
    if (!meshedPattern_ || !(*meshedPattern_ == scene.pattern)) {
        meshedPattern_ = scene.pattern;
        preview_.request(scene.pattern, ++patternGeneration_);
    }
    if (bodyLoading_ || (scene_ && *scene_ == scene)) return;
    ++generation_;
    scene_ = std::move(scene);
    if (!parts_.simulation) return;
    parts_.simulation->setScene(*scene_, generation_);
    if (std::exchange(resetNext_, false)) parts_.simulation->reset(); // another document: its drape is not carried over
    frames_.start();
}

void Workbench::record() {
    if (!journal_ || !isModified()) return;
    if (auto written = journal_->record(document(), path_); !written)
        tell(QString::fromStdString(toString(written.error())), true);
}

} // namespace toile::ui
