// SPDX-License-Identifier: GPL-3.0-or-later
// The avatar of a garment that is worn moves.
#include "core/body/ArmLift.h"
#include "ui/workbench/Workbench.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <numbers>
#include <utility>

namespace toile::ui {

/// In no direction.
QString Workbench::whyAvatarStays() const {
    if (bodyLoading_) return tr("The avatar is still being read.");
    if (!body_) return tr("There is no avatar that could move.");
    if (!frame_) return tr("There is no garment on the avatar.");
    if (method_ != dynamics::Method::xpbd)
        return tr("Beside an avatar that moves only the fast method drapes: choose it under Simulation, Method.");
    if (frame_->phase != simulation::Phase::draping)
        return tr("The avatar moves when the garment is worn: simulate until its seams are closed and it hangs.");
    if (frame_->bodyMoves) return tr("The avatar is moving already.");
    if (motionLoading_) return tr("The poses are still being read.");
    return {};
}

QString Workbench::whyNotMoved() const {
    const QString why = whyAvatarStays();
    return why.isEmpty() && bodyHasMoved() ? tr("The avatar stands in another pose: move it back first.") : why;
}

QString Workbench::whyNotMovedBack() const {
    const QString why = whyAvatarStays();
    return why.isEmpty() && !(bodyHasMoved() && motion_) ? tr("The avatar stands as it did at first.") : why;
}

void Workbench::liftArms() {
    constexpr double angle = std::numbers::pi / 3, seconds = 1;
    if (armsAreUp()) return moveBack();
    if (const QString why = whyNotMoved(); !why.isEmpty()) return tell(why, true);
    auto lift = body::armLift(**body_, angle, seconds);
    if (!lift) return tell(QString::fromStdString(toString(lift.error())), true);
    move(std::move(*lift), true);
}

void Workbench::moveThroughPoses(const QString& folder, double step) {
    if (const QString why = whyNotMoved(); !why.isEmpty()) return tell(why, true);
    motionLoading_ = true;
    motionThread_ = std::jthread([this, body = *body_, folder = folder.toStdString(), step, read = parts_.readMotion] {
        auto motion = read(folder, *body, step);
        QMetaObject::invokeMethod(this, [this, body, motion = std::move(motion)] { takeMotion(body, motion); });
    });
    tell(tr("Reading the poses in %1…").arg(QFileInfo(QDir::cleanPath(folder)).fileName()));
    Q_EMIT posesRead();
}

void Workbench::takeMotion(const Shared<body::Body>& body, Result<geometry::VertexMotion> motion) {
    motionLoading_ = false;
    Q_EMIT posesRead();
    if (!motion) return tell(QString::fromStdString(toString(motion.error())), true);
    if (!body_ || !body_->sameAs(body)) return tell(tr("The poses are of the avatar before."), true);
    if (const QString why = whyNotMoved(); !why.isEmpty()) return tell(why, true);
    const QString seconds = QString::number(motion->duration(), 'f', 2);
    tell(tr("The avatar moves through %1 poses in %2 s.").arg(motion->poses.size()).arg(seconds));
    move(std::move(*motion), false);
}

void Workbench::moveBack() {
    if (const QString why = whyNotMovedBack(); !why.isEmpty()) return tell(why, true);
    geometry::VertexMotion back = *motion_;
    std::ranges::reverse(back.poses);
    parts_.simulation->moveBody(std::make_shared<const geometry::VertexMotion>(std::move(back)));
    follow();
}

void Workbench::move(geometry::VertexMotion motion, bool liftsArms) {
    motion_ = std::make_shared<const geometry::VertexMotion>(std::move(motion));
    movesArms_ = liftsArms;
    parts_.simulation->moveBody(motion_);
    follow();
}

} // namespace toile::ui
