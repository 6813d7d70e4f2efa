// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Frame.h"

#include <QStatusBar>
#include <QTimer>

class QLabel;

namespace toile::ui {

class ElidedLabel;

/// What the simulation says: its parts for the status line, in the trade's units.
struct SimulationTexts {
    QString time, rate, particles, gap;
};
[[nodiscard]] SimulationTexts textsOf(const simulation::Frame& frame);

/// Message, pointer, simulated time, frames per second, particles, largest seam gap.
class StatusLine : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusLine(QWidget* parent = nullptr);

    /// Problems stay until the next message, others go after a while.
    void tell(const QString& message, bool isProblem);
    /// Of what was just tried; a problem that stands is seen again after a while.
    void hint(const QString& message);
    void showPointer(Vec2 position);
    void showMethod(const QString& name); ///< of another than the usual; empty = the usual
    void showFrame(const simulation::Frame* frame, bool playing);

private:
    struct Message {
        QString text;
        bool isProblem = false;
    };
    void present(const Message& message);
    void fade();

    QTimer fade_{this};
    Message standing_;
    ElidedLabel* message_;
    QLabel *pointer_, *state_, *method_, *time_, *rate_, *particles_, *gap_;
};

} // namespace toile::ui
