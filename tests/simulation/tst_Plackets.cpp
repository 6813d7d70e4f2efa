// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sewn.h"
#include "SmallScenes.h"
#include "core/simulation/Inspect.h"
#include "core/simulation/Openings.h"
#include "core/simulation/Plackets.h"
#include "core/simulation/RightSide.h"
#include "tests/Suite.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr int columns = 49, rows = 21;
constexpr double radius = 0.1, overlap = 0.03, rise = 0.004, rowSpacing = 0.02; // [m]

int particle(int column, int row) {
    return row * columns + column;
}

/// A band wound round an upright axis by more than once: its end lies `rise` outside its beginning. Two pieces, sewn
/// behind; right side out.
struct Wound {
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> piece;
    std::vector<Vec3> positions;

    Wound() {
        const double sweep = 2 * std::numbers::pi + overlap / radius;
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                const double share = static_cast<double>(column) / (columns - 1);
                const double angle = sweep * (share - 0.5), r = radius + rise * share;
                positions.push_back({r * std::sin(angle), rowSpacing * row, -r * std::cos(angle)});
            }
        for (int row = 0; row + 1 < rows; ++row)
            for (int column = 0; column + 1 < columns; ++column) {
                const int a = particle(column, row), b = particle(column + 1, row), c = particle(column + 1, row + 1),
                          d = particle(column, row + 1);
                triangles.push_back({a, c, b});
                triangles.push_back({a, d, c});
                piece.insert(piece.end(), 2, column < columns / 2 ? 0 : 1);
            }
    }

    static constexpr int inset = 2; ///< columns from either edge to the buttons: they lie one over the other

    [[nodiscard]] HeldTogether tackAt(int row) const {
        return {{0, 1}, {positions[particle(inset, row)], positions[particle(columns - 1 - inset, row)]}};
    }

    [[nodiscard]] std::vector<std::array<int, 3>> buttonedAt(const std::vector<int>& tacked) const {
        std::vector<HeldTogether> tacks;
        for (const int row : tacked) tacks.push_back(tackAt(row));
        auto all = triangles;
        const auto plackets = placketsOf(triangles, piece, positions, tacks);
        all.insert(all.end(), plackets.begin(), plackets.end());
        return all;
    }
};

/// A panel that reaches from `from` to the left, and its mirror image.
Scene panelAndImage(double from, int layerOfImage = 1) {
    pattern::Piece left = polygonPiece("left", {{from, 0}, {0.3, 0}, {0.3, 0.2}, {from, 0.2}}, 0.02), right = left;
    left.placement = pattern::Placement{};
    right.id = pattern::PieceId{"right"};
    right.outline = {};
    right.mirror = pattern::MirrorOf{left.id, {0, 0}, {0, 1}};
    right.placement = left.placement;
    right.layer = layerOfImage;
    Scene scene;
    scene.pattern.fabrics.push_back(plainCloth());
    scene.pattern.pieces = {left, right};
    return scene;
}

} // namespace

class tst_Plackets : public QObject {
    Q_OBJECT
private slots:
    void aBandThatIsNotButtonedHasOneBorder();
    void buttonsFromEndToEndLeaveTheTwoRims();
    void whatIsBeyondTheLastButtonsStaysOpen();
    void theOrderOfButtonsDoesNotMatter();
    void oneButtonAndNoneFillNothing();
    void aTackInTheMiddleOfTheClothIsNoPlacket();
    void theRightSideGoesOnAcrossIt();
    void cornersThatLieOverTheirImageAreNoLandmarks();

private:
    const Wound band;
};

void tst_Plackets::aBandThatIsNotButtonedHasOneBorder() {
    const auto openings = openingsOf(band.triangles);
    QCOMPARE(openings.size(), std::size_t(1));
    QCOMPARE(openings[0].size(), std::size_t(2 * (columns + rows) - 4));
}

void tst_Plackets::buttonsFromEndToEndLeaveTheTwoRims() {
    const auto openings = openingsOf(band.buttonedAt({0, 5, 10, 15, 20}));
    QCOMPARE(openings.size(), std::size_t(2));
    for (const Opening& rim : openings)
        QCOMPARE(rim.size(), std::size_t(columns - 2 * Wound::inset)); // closed from button to button
}

void tst_Plackets::whatIsBeyondTheLastButtonsStaysOpen() {
    const auto openings = openingsOf(band.buttonedAt({3, 10, 18}));
    QCOMPARE(openings.size(), std::size_t(2));
    std::vector<std::size_t> lengths{openings[0].size(), openings[1].size()};
    std::ranges::sort(lengths);
    QCOMPARE(lengths[0], std::size_t(columns + 2 * 2)); // two rows above the upper button, on either edge
    QCOMPARE(lengths[1], std::size_t(columns + 2 * 3));
}

void tst_Plackets::theOrderOfButtonsDoesNotMatter() {
    QCOMPARE(openingsOf(band.buttonedAt({18, 3, 10})).size(), std::size_t(2));
}

void tst_Plackets::oneButtonAndNoneFillNothing() {
    QCOMPARE(band.buttonedAt({}).size(), band.triangles.size());
    QCOMPARE(band.buttonedAt({10}).size(), band.triangles.size());
}

void tst_Plackets::aTackInTheMiddleOfTheClothIsNoPlacket() {
    const HeldTogether far{{0, 0}, {band.positions[particle(12, 8)], band.positions[particle(12, 12)]}};
    QVERIFY(placketsOf(band.triangles, band.piece, band.positions, std::vector{far, far, band.tackAt(10)}).empty());
}

void tst_Plackets::theRightSideGoesOnAcrossIt() {
    const auto buttoned = band.buttonedAt({0, 5, 10, 15, 20});
    QVERIFY(turnedEdgesOf(buttoned).empty());
    QVERIFY(rightSideOutShare(buttoned, band.positions) > 0.99);
    auto insideOut = buttoned;
    for (auto& triangle : insideOut) std::swap(triangle[1], triangle[2]);
    QVERIFY(rightSideOutShare(insideOut, band.positions) < 0.01);
}

void tst_Plackets::cornersThatLieOverTheirImageAreNoLandmarks() {
    for (const double from : {0.05, 0.0})
        QCOMPARE(drapeOf(simulationOf(panelAndImage(from))).mirrorPairs.size(), std::size_t(4));
    QCOMPARE(drapeOf(simulationOf(panelAndImage(-0.015))).mirrorPairs.size(), std::size_t(2));
    // Of one layer neither is meant to lie over the other.
    QCOMPARE(drapeOf(simulationOf(panelAndImage(-0.015, 0))).mirrorPairs.size(), std::size_t(4));
}

TOILE_TEST(tst_Plackets)
#include "tst_Plackets.moc"
