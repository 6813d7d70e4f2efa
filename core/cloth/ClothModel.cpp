// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/ClothModel.h"

namespace toile::cloth {
namespace {

template <class T>
std::size_t held(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

} // namespace

std::size_t bytesOf(const ClothModel& model) {
    std::size_t bytes = held(model.mass) + held(model.pinned) + held(model.slaves) + held(model.structural) +
                        held(model.shear) + held(model.elastics) + held(model.flexion) + held(model.bending) +
                        held(model.twist) + held(model.hinges) + held(model.triangles) + held(model.cells) +
                        held(model.tensionCurves);
    for (const Slave& slave : model.slaves) bytes += held(slave.masters);
    for (const TensionCurves& curves : model.tensionCurves) bytes += held(curves.warp) + held(curves.weft);
    return bytes;
}

} // namespace toile::cloth
