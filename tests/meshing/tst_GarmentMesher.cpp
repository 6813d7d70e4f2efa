// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/GarmentMesher.h"
#include "tests/Suite.h"
#include "tests/meshing/RandomMeshInput.h"

#include <QTest>

using namespace toile;
using namespace toile::meshing;

/// A mesher with a memory gives what one without gives, and leaves alone what an edit does not touch.
class tst_GarmentMesher : public QObject {
    Q_OBJECT
private slots:
    void anEditMeshesWhatItTouches_data();
    void anEditMeshesWhatItTouches();
    void anErrorIsForgotten();
    void randomEditsGiveTheMeshFromScratch();
};

using Edit = void (*)(MeshInput&);

namespace {

GarmentMesh untimed(GarmentMesh garment) {
    for (PieceReport& piece : garment.report.pieces) piece.seconds = 0;
    garment.report.total.seconds = 0;
    return garment;
}

/// Empty when both say the same.
std::string difference(const Result<const GarmentMesh*>& again, const Result<GarmentMesh>& anew) {
    if (again.has_value() != anew.has_value()) return "one is refused";
    if (!anew) return again.error() == anew.error() ? "" : "other errors";
    return untimed(**again) == untimed(*anew) ? "" : "other meshes";
}

/// Three panels; the first two are sewn side to side.
MeshInput threePanels() {
    MeshInput input{{rectanglePiece(0.3, 0.5, 0.02, "Front"), rectanglePiece(0.3, 0.5, 0.02, "Back"),
                     rectanglePiece(0.2, 0.4, 0.02, "Pocket")},
                    {}};
    input.pieces[1].regions = {{"seat", {{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.1, 0.2}}, {}, 1}};
    input.seams = {{"side", {{{{0, 0, 1}}, {{1, 0, 1}}}}, {}}};
    return input;
}

/// Moves the first corner of an edge with both edges that meet there.
void moveCorner(PieceInput& piece, std::size_t edge, Vec2 by) {
    const std::size_t before = (edge + piece.outline.size() - 1) % piece.outline.size();
    piece.outline[edge].curve.start += by;
    piece.outline[before].curve.end += by;
}

void change(MeshInput& input, Random& random) {
    PieceInput& piece =
        input.pieces[static_cast<std::size_t>(random.whole(0, static_cast<int>(input.pieces.size()) - 1))];
    switch (random.whole(0, 7)) {
    case 0: piece.spacing *= random(0.7, 1.4); break;
    case 1: piece.grain += random(-0.3, 0.3); break;
    case 2: piece.regions.clear(); break;
    case 3:
        if (!input.seams.empty()) input.seams.pop_back();
        break;
    case 4: input.pieces.push_back(rectanglePiece(0.2, 0.3, 0.03, "New")); break;
    default: {
        const int last = static_cast<int>(piece.outline.size()) - 1;
        moveCorner(piece, static_cast<std::size_t>(random.whole(0, last)), {random(-0.01, 0.01), random(-0.01, 0.01)});
    }
    }
}

} // namespace

void tst_GarmentMesher::anEditMeshesWhatItTouches_data() {
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<int>("checkedPieces");
    QTest::addColumn<int>("meshedPieces");
    const auto row = [](const char* name, Edit edit, int checkedPieces, int meshedPieces) {
        QTest::newRow(name) << edit << checkedPieces << meshedPieces;
    };
    row(
        "nothing", [](MeshInput&) {}, 0, 0);
    row(
        "a corner",
        [](MeshInput& input) {
            moveCorner(input.pieces[0], 0, {0.003, 0.004});
        },
        1, 1);
    row(
        "a corner of a sewn edge, whose nodes become more on both sides",
        [](MeshInput& input) {
            moveCorner(input.pieces[0], 2, {0, 0.04});
            input.seams[0].sections = {{.ease = 0.04}};
        },
        1, 2);
    row(
        "a region",
        [](MeshInput& input) {
            for (Vec2& corner : input.pieces[1].regions[0].outline) corner += Vec2{0.02, 0.02};
        },
        1, 1);
    row(
        "a piece taken", [](MeshInput& input) { input.pieces.pop_back(); }, 0, 0);
}

void tst_GarmentMesher::anEditMeshesWhatItTouches() {
    QFETCH(Edit, edit);
    MeshInput input = threePanels();
    GarmentMesher mesher;
    QVERIFY(mesher.mesh(input));
    QCOMPARE(mesher.work().meshedPieces, 3);
    edit(input);
    const auto again = mesher.mesh(input);
    QVERIFY2(again, again ? "" : toString(again.error()).c_str());
    QTEST(mesher.work().checkedPieces, "checkedPieces");
    QTEST(mesher.work().meshedPieces, "meshedPieces");
    QCOMPARE(difference(again, meshGarment(input)), "");
}

void tst_GarmentMesher::anErrorIsForgotten() {
    const MeshInput good = threePanels();
    MeshInput bad = good;
    moveCorner(bad.pieces[0], 0, {0.4, 0.6}); // the border crosses itself
    GarmentMesher mesher;
    QVERIFY(mesher.mesh(good));
    QCOMPARE(difference(mesher.mesh(bad), meshGarment(bad)), "");
    const auto again = mesher.mesh(good);
    QVERIFY(again);
    QCOMPARE(mesher.work().meshedPieces, 1);
    QCOMPARE(difference(again, meshGarment(good)), "");
}

void tst_GarmentMesher::randomEditsGiveTheMeshFromScratch() {
    int refused = 0, meshed = 0, kept = 0;
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        MeshInput input = RandomMeshInput(seed)();
        Random random(seed);
        GarmentMesher mesher;
        for (int edit = 0; edit < 6; ++edit) {
            const auto again = mesher.mesh(input);
            const std::string differ = difference(again, meshGarment(input));
            QVERIFY2(differ.empty(), (differ + " at seed " + std::to_string(seed)).c_str());
            ++(again ? meshed : refused);
            if (again) kept += static_cast<int>(input.pieces.size()) - mesher.work().meshedPieces;
            change(input, random);
        }
    }
    qInfo("%d meshed, %d refused, %d pieces kept", meshed, refused, kept);
    QVERIFY(meshed > 200);
    QVERIFY(refused > 20);
    QVERIFY(kept > 100);
}

TOILE_TEST(tst_GarmentMesher)
#include "tst_GarmentMesher.moc"
