// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/Workbench.h"

#include "core/document/DocumentEdits.h"

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

} // namespace

Workbench::Workbench(WorkbenchParts parts, QObject* parent)
    : QObject(parent), parts_(std::move(parts)), preview_(parts_.mesh) {
    if (!parts_.recoveryFolder.isEmpty()) journal_.emplace(parts_.recoveryFolder, parts_.write);
    connect(&preview_, &MeshPreview::meshed, this, [this](const MeshedPattern& result) {
        if (result.generation != patternGeneration_) return; // a newer pattern is being meshed
        meshed_ = result;
        Q_EMIT meshChanged();
        takeBack(Complaint::ofMesh);
    });
    connect(&preview_, &MeshPreview::failed, this, [this](quint64 generation, const QString& why) {
        if (generation != patternGeneration_) return;
        meshed_ = {generation, {}, {}};
        Q_EMIT meshChanged();
        tell(why, true);
        complaint_ = Complaint::ofMesh;
    });
    frames_.setInterval(framePeriod);
    connect(&frames_, &QTimer::timeout, this, &Workbench::pollFrame);
    recovery_.setSingleShot(true);
    recovery_.setInterval(parts_.recoveryDelay);
    connect(&recovery_, &QTimer::timeout, this, [this] {
        if (auto recorded = record(); !recorded) tell(QString::fromStdString(toString(recorded.error())), true);
    });
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
    recordSoon();
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
    recordSoon();
    Q_EMIT fileChanged();
}

void Workbench::redo() {
    if (!history_.canRedo()) return;
    history_.redo();
    documentMoved();
    recordSoon();
    Q_EMIT fileChanged();
}

void Workbench::importAvatar(const QString& path) {
    const QString file = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    bodyFile_.reset();
    apply({tr("Import avatar"), document::withAvatar(document(), file.toStdString())});
}

void Workbench::removeAvatar() {
    apply({tr("Remove avatar"), document::withAvatar(document(), {})});
}

void Workbench::tell(const QString& message, bool isProblem) {
    complaint_ = Complaint::none;
    Q_EMIT messageChanged(message, isProblem);
}

/// What was wrong is right again; what was told since stays.
void Workbench::takeBack(Complaint complaint) {
    if (complaint_ == complaint) tell({});
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
    const QString file = QString::fromStdString(document().avatarFile);
    if (file == bodyFile_) return;
    bodyFile_ = file;
    const std::uint64_t reading = ++bodyReading_;
    bodyLoading_ = !file.isEmpty() && parts_.readBody;
    if (!bodyLoading_) {
        body_.reset();
        Q_EMIT bodyChanged();
        return;
    }
    bodyThread_ = std::jthread([this, reading, file = file.toStdString(), read = parts_.readBody] {
        auto body = read(file);
        QMetaObject::invokeMethod(this, [this, reading, body = std::move(body)] { takeBody(reading, body); });
    });
}

void Workbench::takeBody(std::uint64_t reading, Result<body::Body> body) {
    if (reading != bodyReading_) return; // another one is wanted by now
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

} // namespace toile::ui
