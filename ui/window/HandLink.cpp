// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/HandLink.h"

namespace toile::ui {

HandLink::HandLink(Workbench& workbench, View3D& view, QObject* parent)
    : QObject(parent), workbench_(workbench), view_(view) {
    connect(&view, &View3D::clothPulled, this, &HandLink::pull);
    connect(&view, &View3D::clothLetGo, this, &HandLink::letGo);
    connect(&view, &View3D::pinClicked, this, &HandLink::takeOut);
    connect(&workbench, &Workbench::playingChanged, this, [this] { view_.setPulling(workbench_.isPlaying()); });
    connect(&workbench, &Workbench::documentReplaced, this, &HandLink::freeAll);
    connect(&workbench, &Workbench::frameArrived, this, [this] {
        if (!workbench_.frame() || workbench_.frame()->time == 0) freeAll();
    });
    view.setPulling(workbench.isPlaying());
}

void HandLink::pull(const HeldPlace& place, std::optional<std::size_t> pin) {
    const bool begins = !pulled_ && !moved_;
    if (pin && *pin < pins_.size()) {
        moved_ = pin;
        pins_[*pin] = place;
    } else {
        pulled_ = place;
    }
    if (begins) workbench_.tell(tr("Let go with Shift held to leave a pin; a click takes a pin out."));
    handOver();
}

void HandLink::letGo(bool keep) {
    if (pulled_ && keep) pins_.push_back(*pulled_);
    pulled_.reset();
    moved_.reset();
    handOver();
}

void HandLink::takeOut(std::size_t pin) {
    if (pin >= pins_.size()) return;
    pins_.erase(pins_.begin() + static_cast<std::ptrdiff_t>(pin));
    handOver();
}

void HandLink::freeAll() {
    if (pins_.empty() && !pulled_ && !moved_) return;
    pins_.clear();
    pulled_.reset();
    moved_.reset();
    handOver();
}

void HandLink::handOver() {
    std::vector<simulation::Grip> grips;
    const auto add = [&](const HeldPlace& place) { grips.push_back({place.piece, place.material, place.target}); };
    for (const HeldPlace& pin : pins_) add(pin);
    if (pulled_) add(*pulled_);
    workbench_.hold(std::move(grips));
    view_.setPins(pins_);
}

} // namespace toile::ui
