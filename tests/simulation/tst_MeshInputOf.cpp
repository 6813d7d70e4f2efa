// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/MeshInputOf.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

class tst_MeshInputOf : public QObject {
    Q_OBJECT
private slots:
    void piecesAndSeamsKeepTheirOrder();
    void aMirrorPieceIsWalkedTheOtherWay();
    void notchesAtTheEndsOfAnEdgeAreTold();
    void anUnknownEdgeIsNamed();
    void spacingCanBeOverridden();
};

void tst_MeshInputOf::piecesAndSeamsKeepTheirOrder() {
    const auto input = meshInputOf(twoSquares().pattern);
    QVERIFY(input);
    QCOMPARE(input->pieces.size(), std::size_t(2));
    const auto& seam = input->seams.front();
    QCOMPARE(seam.sides[0][0].piece, 0);
    QCOMPARE(seam.sides[0][0].edge, 1);
    QCOMPARE(seam.sides[1][0].piece, 1);
    QCOMPARE(seam.sides[1][0].edge, 3);
    QVERIFY(seam.sides[1][0].reversed);
}

void tst_MeshInputOf::aMirrorPieceIsWalkedTheOtherWay() {
    auto pattern = twoSquares().pattern;
    pattern::Piece image;
    image.id = pattern::PieceId("image");
    image.fabric = material::FabricId("cloth");
    image.mirror = pattern::MirrorOf{pattern::PieceId("left"), {0, 0}, {0, 1}};
    pattern.pieces.push_back(image);
    pattern::Seam seam = seamBetween("s", "left", "e1", "image", "e1");
    seam.sides[1][0] = {pattern::PieceId("image"), pattern::EdgeId("e1"), 0.25, 0.5, false};
    pattern.seams = {seam};
    const auto input = meshInputOf(pattern);
    QVERIFY(input);
    QVERIFY(input->pieces[2].mirrored);
    const auto& part = input->seams[0].sides[1][0];
    QCOMPARE(part.from, 0.5); // along the source from 0.25 to 0.5 = along the image from 0.75 down to 0.5
    QCOMPARE(part.to, 0.75);
    QVERIFY(part.reversed);
    // The point where the walk begins is the mirror image of the source's.
    const auto& curve = input->pieces[2].outline[part.edge].curve;
    const Vec2 start = geometry::ArcLength(curve).pointAt(part.to);
    QVERIFY(geometry::distance(start, {-0.2, 0.25 * 0.2}) < 1e-12);
}

void tst_MeshInputOf::notchesAtTheEndsOfAnEdgeAreTold() {
    auto pattern = twoSquares().pattern;
    pattern::Piece left = *pattern.pieces[0];
    for (const double position : {1.0, 0.5, 0.0}) left.notches.push_back({pattern::EdgeId("e1"), position});
    pattern.pieces[0] = left;
    QCOMPARE(meshInputOf(pattern)->pieces[0].outline[1].notches, (std::vector<double>{0, 0.5, 1}));
}

void tst_MeshInputOf::anUnknownEdgeIsNamed() {
    auto pattern = twoSquares().pattern;
    pattern.seams[0].sides[1][0].edge = pattern::EdgeId("hem");
    const auto input = meshInputOf(pattern);
    QVERIFY(!input);
    QCOMPARE(input.error().text, std::string("Piece \"right\" has no edge \"hem\"."));
}

void tst_MeshInputOf::spacingCanBeOverridden() {
    const auto input = meshInputOf(twoSquares().pattern, {.spacing = 0.005});
    QCOMPARE(input->pieces[1].spacing, 0.005);
}

TOILE_TEST(tst_MeshInputOf)
#include "tst_MeshInputOf.moc"
