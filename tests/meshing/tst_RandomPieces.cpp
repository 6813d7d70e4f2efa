// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/meshing/MeshReferee.h"

#include <QTest>
#include <fmt/format.h>

using namespace toile;
using namespace toile::meshing;

/// Seeded random inputs: each gives a sound mesh or a sentence, never a crash.
class tst_RandomPieces : public QObject {
    Q_OBJECT
private slots:
    void simplePiecesAlwaysMesh();
    void garbageIsMeshedOrRefused();
    void sewnPairsAgree();
};

namespace {

/// A small generator of our own, so that a seed means the same everywhere.
struct CongruentialRandom {
    std::uint64_t state;
    double operator()(double low, double high) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return low + (high - low) * static_cast<double>(state >> 11) / 9007199254740992.0;
    }
    int whole(int low, int high) { return low + static_cast<int>((*this)(0, 1) * (high - low + 1)); }
};

/// Star-shaped, hence simple; some sides curved gently, some notched.
PieceInput starPiece(CongruentialRandom& random) {
    const int n = random.whole(3, 14);
    std::vector<Vec2> corners;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random(-0.3, 0.3)) / n, r = random(0.05, 0.4);
        corners.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    PieceInput piece = polygonPiece(corners, random(0.006, 0.06));
    for (BoundaryEdge& edge : piece.outline)
        if (random(0, 1) < 0.3) edge.notches = {random(0.1, 0.5), random(0.5, 0.9)};
    piece.grain = random(-4, 4);
    piece.rule = static_cast<LineRule>(random.whole(0, 2));
    piece.border = static_cast<RegionBorder>(random.whole(0, 1));
    piece.mirrored = random(0, 1) < 0.3;
    for (int r = random.whole(0, 2); r > 0; --r) {
        const double x = random(-0.1, 0.1), y = random(-0.1, 0.1), w = random(0.05, 0.2), h = random(0.05, 0.2);
        piece.regions.push_back(
            {fmt::format("r{}", r), {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, {}, random.whole(0, 2)});
    }
    return piece;
}

} // namespace

void tst_RandomPieces::simplePiecesAlwaysMesh() {
    int meshed = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CongruentialRandom random{seed * 7919};
        const PieceInput piece = starPiece(random);
        const auto garment = meshGarment(inputOf(piece));
        if (!garment) { // the one thing that may be wrong with these: where their regions lie
            QVERIFY2(
                garment.error().place.object.find("region") != std::string::npos,
                qPrintable(QString("seed %1: %2").arg(seed).arg(QString::fromStdString(toString(garment.error())))));
            continue;
        }
        ++meshed;
        const std::string defect = defectOf(garment->pieces[0]);
        QVERIFY2(defect.empty(), qPrintable(QString("seed %1: %2").arg(seed).arg(QString::fromStdString(defect))));
    }
    QVERIFY(meshed > 250);
}

void tst_RandomPieces::garbageIsMeshedOrRefused() {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CongruentialRandom random{seed * 104729};
        PieceInput piece;
        piece.label = "Garbage";
        piece.spacing = random(0.005, 0.1);
        std::vector<Vec2> corners;
        for (int i = random.whole(1, 7); i > 0; --i)
            corners.push_back({0.05 * random.whole(0, 4), 0.05 * random.whole(0, 4)});
        piece.outline = loopThrough(corners);
        for (BoundaryEdge& edge : piece.outline) {
            if (random(0, 1) < 0.15) edge.curve.shape = geometry::ArcShape{random(-1.5, 1.5)};
            if (random(0, 1) < 0.15)
                edge.curve.shape =
                    geometry::CubicShape{{random(0, 0.2), random(0, 0.2)}, {random(0, 0.2), random(0, 0.2)}};
        }
        const auto garment = meshGarment(inputOf(piece));
        if (!garment) {
            QVERIFY(!garment.error().text.empty() && garment.error().place.object.find("Garbage") != std::string::npos);
            continue;
        }
        const std::string defect = defectOf(garment->pieces[0]);
        QVERIFY2(defect.empty(), qPrintable(QString("seed %1: %2").arg(seed).arg(QString::fromStdString(defect))));
    }
}

void tst_RandomPieces::sewnPairsAgree() {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CongruentialRandom random{seed * 15485863};
        PieceInput piece = starPiece(random);
        piece.regions.clear();
        PieceInput other = piece;
        other.spacing = random(0.006, 0.06);
        const int edge = random.whole(0, static_cast<int>(piece.outline.size()) - 1);
        const double from = random(0, 0.4), to = random(0.6, 1);
        MeshInput input{{piece, other}, {}};
        input.seams = {{"s", {{{{0, 0, edge, from, to, true}}, {{1, 0, edge, from, to, true}}}}, {}}};
        const auto garment = meshGarment(input);
        QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
        for (const auto& [a, b] : garment->seams[0].pairs)
            QVERIFY(distance(garment->pieces[0].nodes[static_cast<std::size_t>(a.node)],
                             garment->pieces[1].nodes[static_cast<std::size_t>(b.node)]) < 1e-14);
        for (const PieceMesh& mesh : garment->pieces) QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
    }
}

TOILE_TEST(tst_RandomPieces)
#include "tst_RandomPieces.moc"
