// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/StatusLine.h"

#include "ui/values/Units.h"
#include "ui/window/ElidedLabel.h"

#include <QLabel>

namespace toile::ui {
namespace {

QLabel* field(StatusLine& line, const char* name, int width, const QString& tip) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setMinimumWidth(width);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setToolTip(tip);
    line.addPermanentWidget(label);
    return label;
}

QString stateOf(const simulation::Frame* frame, bool playing) {
    if (frame && frame->finish == simulation::Finish::underWay) return StatusLine::tr("Finishing…");
    if (frame && frame->finish == simulation::Finish::found) return StatusLine::tr("In equilibrium");
    if (frame && frame->atRest) return StatusLine::tr("At rest");
    return playing ? StatusLine::tr("Running") : StatusLine::tr("Paused");
}

} // namespace

SimulationTexts textsOf(const simulation::Frame& frame) {
    return {textOf(Quantity::time, frame.time),
            StatusLine::tr("%1 frames/s")
                .arg(QString::number(frame.framesPerSecond, 'f', frame.framesPerSecond < 10 ? 1 : 0)),
            StatusLine::tr("%1 particles").arg(frame.particles),
            StatusLine::tr("gap %1").arg(textOf(Quantity::length, frame.largestSeamGap))};
}

StatusLine::StatusLine(QWidget* parent) : QStatusBar(parent) {
    setSizeGripEnabled(false);
    message_ = new ElidedLabel;
    message_->setObjectName(QStringLiteral("statusMessage"));
    message_->setContentsMargins(8, 0, 0, 0);
    addWidget(message_, 1);
    pointer_ = field(*this, "statusPointer", 130, tr("Pointer on the pattern table"));
    state_ = field(*this, "statusState", 96, tr("State of the simulation"));
    method_ = field(*this, "statusMethod", 0, tr("Method by which the sewn garment is draped"));
    time_ = field(*this, "statusTime", 64, tr("Simulated time"));
    rate_ = field(*this, "statusRate", 96, tr("Simulated frames computed a second"));
    particles_ = field(*this, "statusParticles", 100, tr("Particles of the cloth"));
    gap_ = field(*this, "statusGap", 116, tr("Largest distance between points that are sewn together"));
    gap_->setContentsMargins(0, 0, 10, 0);
    showMethod({});
    showFrame(nullptr, false);
    fade_.setSingleShot(true);
    fade_.setInterval(std::chrono::seconds(12));
    connect(&fade_, &QTimer::timeout, this, &StatusLine::fade);
}

void StatusLine::tell(const QString& message, bool isProblem) {
    standing_ = {message, isProblem};
    present(standing_);
}

void StatusLine::hint(const QString& message) {
    if (!standing_.isProblem) standing_ = {};
    present({message, false});
}

void StatusLine::present(const Message& message) {
    message_->show(message.text);
    message_->setStyleSheet(message.isProblem ? QStringLiteral("color: #b02a2a;") : QString());
    if (message.isProblem || message.text.isEmpty()) fade_.stop();
    else fade_.start();
}

void StatusLine::fade() {
    if (!standing_.isProblem) standing_ = {};
    present(standing_);
}

void StatusLine::showPointer(Vec2 position) {
    pointer_->setText(tr("%1, %2").arg(textOf(Quantity::length, position.x), textOf(Quantity::length, position.y)));
}

void StatusLine::showMethod(const QString& name) {
    method_->setText(name);
    method_->setVisible(!name.isEmpty());
}

void StatusLine::showFrame(const simulation::Frame* frame, bool playing) {
    const SimulationTexts texts = frame ? textsOf(*frame) : SimulationTexts{};
    const bool rests = frame && frame->atRest;
    state_->setText(stateOf(frame, playing));
    time_->setText(texts.time);
    rate_->setText(playing && !rests ? texts.rate : QString());
    particles_->setText(texts.particles);
    gap_->setText(texts.gap);
}

} // namespace toile::ui
