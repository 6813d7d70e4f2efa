// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view3d/View3D.h"
#include "ui/workbench/Workbench.h"

#include <QObject>

namespace toile::ui {

/// Lets the pointer hold the cloth while it is simulated: what is dragged in the 3D view becomes grips of the
/// simulation.
///
/// A place let go with Shift stays a pin, to be dragged again or clicked away. Pins are of the moment and not of the
/// document: a reset frees them.
class HandLink : public QObject {
    Q_OBJECT
public:
    HandLink(Workbench& workbench, View3D& view, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<HeldPlace>& pins() const { return pins_; }

private:
    void pull(const HeldPlace& place, std::optional<std::size_t> pin);
    void letGo(bool keep);
    void takeOut(std::size_t pin);
    void freeAll();
    void handOver();

    Workbench& workbench_;
    View3D& view_;
    std::vector<HeldPlace> pins_;
    std::optional<HeldPlace> pulled_;  ///< loose cloth in the hand
    std::optional<std::size_t> moved_; ///< the pin in the hand
};

} // namespace toile::ui
