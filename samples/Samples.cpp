// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Samples.h"

#include "samples/Blouse.h"
#include "samples/CircleSkirt.h"
#include "samples/SmallScenes.h"
#include "samples/TShirt.h"
#include "samples/Table.h"
#include "samples/Trousers.h"

namespace toile::samples {

std::vector<NamedDocument> sampleDocuments(const body::Mannequin& mannequin) {
    const body::Measurements& m = mannequin.measurements;
    const body::Body& body = mannequin.body;
    std::vector<NamedDocument> samples{
        {"blouse", blouse(m, body)},
        {"t-shirt", tShirt(m, body)},
        {"circle-skirt", circleSkirt(m, body)},
        {"trousers", trousers(m, body)},
        {"sheet-two-corners", squareSheet(SheetPins::twoCorners)},
        {"sheet-one-edge", squareSheet(SheetPins::oneEdge)},
        {"tablecloth", tablecloth()},
        {"tube", tubeRoundCylinder()},
        {"two-squares", twoSquares()},
    };
    for (NamedDocument& sample : samples) sample.document.pattern = laidOut(sample.document.pattern);
    return samples;
}

std::vector<NamedBody> sampleBodies(const body::Mannequin& mannequin) {
    return {
        {"mannequin", mannequin.body},
        {"table", {"table", tableMesh(), {}, {}}},
        {"cylinder", {"cylinder", cylinderMesh(), {}, {}}},
    };
}

} // namespace toile::samples
