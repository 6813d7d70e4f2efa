// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Samples.h"

#include "samples/Blouse.h"
#include "samples/BodyScenes.h"
#include "samples/CircleSkirt.h"
#include "samples/GatheredSkirt.h"
#include "samples/RegionScenes.h"
#include "samples/Shirt.h"
#include "samples/SmallScenes.h"
#include "samples/TShirt.h"
#include "samples/Table.h"
#include "samples/Trousers.h"

namespace toile::samples {

Result<Wearers> sampleWearers() {
    auto usual = body::makeMannequin({});
    if (!usual) return tl::unexpected(usual.error());
    auto fuller = body::makeMannequin(blouseWearer());
    if (!fuller) return tl::unexpected(fuller.error());
    return Wearers{std::move(*usual), std::move(*fuller)};
}

Result<std::vector<NamedDocument>> sampleDocuments(const Wearers& wearers) {
    const body::Measurements& m = wearers.usual.measurements;
    const body::Body& body = wearers.usual.body;
    auto upper = blouse(wearers.fuller.measurements, wearers.fuller.body),
         buttoned = shirt(wearers.fuller.measurements, wearers.fuller.body), knitted = tShirt(m, body),
         legs = trousers(m, body);
    for (const auto* drafted : {&upper, &buttoned, &knitted, &legs})
        if (!*drafted) return tl::unexpected(drafted->error());
    std::vector<NamedDocument> samples{
        {"blouse", std::move(*upper)},
        {"shirt", std::move(*buttoned)},
        {"t-shirt", std::move(*knitted)},
        {"circle-skirt", circleSkirt(m, body)},
        {"gathered-skirt", gatheredSkirt(m, body)},
        {"trousers", std::move(*legs)},
        {"sheet-two-corners", squareSheet(SheetPins::twoCorners)},
        {"sheet-one-edge", squareSheet(SheetPins::oneEdge)},
        {"tablecloth", tablecloth()},
        {"table-edge", tableEdge()},
        {"tube", tubeRoundCylinder()},
        {"buttoned-band", buttonedBand()},
        {"two-squares", twoSquares()},
        {"finer-over-rod", finerOverRod()},
        {"finer-in-slack", finerInSlack()},
        {"cloth-over-ball", clothOverBall()},
        {"capsule-tunic", capsuleTunic()},
    };
    for (NamedDocument& sample : samples) sample.document.pattern = laidOut(sample.document.pattern);
    return samples;
}

std::vector<NamedBody> sampleBodies(const Wearers& wearers) {
    return {
        {"mannequin", wearers.usual.body},
        {"mannequin-42", wearers.fuller.body},
        {"table", {"table", tableMesh(), {}, {}}},
        {"cylinder", {"cylinder", cylinderMesh(), {}, {}}},
        {"rod", {"rod", rodMesh(), {}, {}}},
        {"ball", {"ball", ballMesh(), {}, {}}},
        {"capsule", {"capsule", capsuleMesh(), {}, {}}},
    };
}

} // namespace toile::samples
