// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest> // first: moc 6.4 stumbles over <compare> as the first header

#include "core/io/ToileFile.h"
#include "samples/CircleSkirt.h"
#include "samples/Measuring.h"
#include "samples/Placing.h"
#include "samples/Samples.h"
#include "samples/SmallScenes.h"
#include "samples/Strokes.h"
#include "samples/TShirt.h"
#include "samples/Trousers.h"
#include "tests/Suite.h"
#include "tests/samples/Corners.h"

using namespace toile;
using namespace toile::pattern;
using namespace toile::samples;

namespace {

constexpr double micrometre = 1e-6; // widths are measured on flattened curves

/// Drafted once for all tests: finding the body takes a second.
const Wearers& wearers() {
    static const Wearers made = *sampleWearers();
    return made;
}

const body::Mannequin& woman() {
    return wearers().usual;
}

const std::vector<NamedDocument>& samplesOfOurs() {
    static const std::vector<NamedDocument> samples = sampleDocuments(wearers()).value();
    return samples;
}

const Pattern& patternOf(const std::string& name) {
    return std::ranges::find(samplesOfOurs(), name, &NamedDocument::name)->document.pattern;
}

const Piece& piece(const Pattern& pattern, const std::string& id) {
    return *findPiece(pattern, PieceId{id});
}
double length(const Piece& piece, const std::string& edge) {
    return edgeLength(piece, edgeId(piece.id.value, edge));
}

/// Of an edge of the outline or of a hole.
geometry::Curve curveNamed(const Piece& piece, const EdgeId& id) {
    const auto holds = [&](const Contour& c) { return std::ranges::count(c.edges, id, &Edge::id) > 0; };
    const Contour& contour = holds(piece.outline) ? piece.outline : *std::ranges::find_if(piece.holes, holds);
    const auto edge = std::ranges::find(contour.edges, id, &Edge::id) - contour.edges.begin();
    return curveOf(contour, static_cast<std::size_t>(edge));
}

} // namespace

class tst_Garments : public QObject {
    Q_OBJECT
private slots:
    void committedFilesAreWhatTheCodeDrafts();
    void sewnEdgesAgreeUpToTheirEase();
    void seamsStartWithinReach();
    void piecesStartClearOfTheBody();
    void mirrorPiecesStartAsMirrorImages();
    void tShirtHasItsEaseAndItsNeckband();
    void circleSkirtFollowsItsFormula();
    void trousersHaveTheirEase();
    void matedCornersAreTrue_data();
    void matedCornersAreTrue();
    void bodiesOfSmallScenesAreClosed();
};

void tst_Garments::committedFilesAreWhatTheCodeDrafts() {
    const std::string folder = qEnvironmentVariable("TOILE_SOURCE_DIR").toStdString() + "/samples/";
    for (const NamedDocument& sample : samplesOfOurs()) {
        const auto committed = io::readToile(folder + sample.name + ".toile");
        QVERIFY2(committed, sample.name.c_str());
        const auto drafted = io::asWritten(sample.document);
        QVERIFY2(drafted && io::toileText(*drafted) == io::toileText(*committed),
                 ("cmake --build … --target samples renews " + sample.name).c_str());
    }
}

void tst_Garments::sewnEdgesAgreeUpToTheirEase() {
    for (const NamedDocument& sample : samplesOfOurs())
        for (const Seam& seam : sample.document.pattern.seams) {
            const double a = sideLength(sample.document.pattern, seam, 0),
                         b = sideLength(sample.document.pattern, seam, 1), difference = a - b;
            double ease = 0;
            for (const SeamSection& section : seam.sections)
                ease += section.gatherRatio ? (*section.gatherRatio - 1) * b : section.ease; // gathered as a whole
            QVERIFY2(std::abs(difference - ease) < 1e-6, (sample.name + ": " + seam.name).c_str());
        }
}

/// Seams are drawn together in 0.6 s: half a metre a second is a calm pace.
void tst_Garments::seamsStartWithinReach() {
    for (const NamedDocument& sample : samplesOfOurs()) {
        const Pattern& pattern = sample.document.pattern;
        for (const Seam& seam : pattern.seams)
            for (const bool atEnd : {false, true}) {
                std::array<Vec3, 2> ends;
                for (std::size_t side = 0; side < 2; ++side) {
                    const SeamPart& part = atEnd ? seam.sides[side].back() : seam.sides[side].front();
                    const Piece whole = resolved(pattern, *findPiece(pattern, part.piece));
                    const geometry::Curve curve = curveNamed(whole, part.edge);
                    const bool backward = part.reversed != whole.mirror.has_value();
                    ends[side] = placed(*whole.placement, atEnd != backward ? curve.end : curve.start);
                }
                QVERIFY2(distance(ends[0], ends[1]) < 0.30, (sample.name + ": " + seam.name).c_str());
            }
    }
}

void tst_Garments::piecesStartClearOfTheBody() {
    for (const char* name : {"t-shirt", "circle-skirt", "gathered-skirt", "trousers"})
        for (const Shared<Piece>& shared : patternOf(name).pieces) {
            if (shared->mirror) continue; // as clear as its source
            QVERIFY2(clearanceOf(*shared, *shared->placement, woman().body) > 0.006, (name + shared->name).c_str());
        }
}

void tst_Garments::mirrorPiecesStartAsMirrorImages() {
    for (const NamedDocument& sample : samplesOfOurs())
        for (const Shared<Piece>& image : sample.document.pattern.pieces) {
            if (!image->mirror) continue;
            const Piece& source = *findPiece(sample.document.pattern, image->mirror->source);
            // Of a higher layer it starts farther out, by 8 mm; a curled one is curled less, and ends elsewhere.
            const bool liesOver = image->layer != source.layer;
            const double apart = !liesOver ? 1e-9 : source.placement->curl ? 0.03 : 0.008 + 1e-9;
            for (const Vertex& vertex : source.outline.vertices) {
                const Vec3 p = placed(*source.placement, vertex.position);
                const Vec3 q = placed(*image->placement, {-vertex.position.x, vertex.position.y});
                const double far = distance({-p.x, p.y, p.z}, q);
                QVERIFY2(far < apart, qPrintable(QString("%1: %2 m").arg(image->name.c_str()).arg(far)));
                QVERIFY2(!liesOver || far > 0.005, image->name.c_str());
            }
        }
}

void tst_Garments::tShirtHasItsEaseAndItsNeckband() {
    const body::Measurements m;
    const TShirtSettings settings;
    const UpperLevels levels = draftUpperBlock(m, figuresOf(m, woman().body.landmarks), settings.block).value().levels;
    const Piece &front = piece(patternOf("t-shirt"), "front"), &back = piece(patternOf("t-shirt"), "back");
    const double chest = widthAt(front, levels.bustFront) + widthAt(back, levels.bustBack);
    QVERIFY(std::abs(chest - m.bust - 0.060) < micrometre);
    const double neckline = 2 * (length(front, "neckline-left") + length(back, "neckline-left"));
    const double ratio = length(piece(patternOf("t-shirt"), "neckband"), "bottom") / neckline;
    QVERIFY(ratio >= 0.82 && ratio <= 0.88);
}

void tst_Garments::circleSkirtFollowsItsFormula() {
    const body::Measurements m;
    const Piece& left = piece(patternOf("circle-skirt"), "skirt-left");
    const double radius = (m.waist + 0.010) / (2 * M_PI);
    const Vec2 waist = vertexPosition(left, vertexId("skirt-left", "waist-front"));
    QVERIFY(std::abs(geometry::length(waist) - radius) < 1e-12);
    QVERIFY(std::abs(2 * (length(left, "waist-front") + length(left, "waist-back")) - m.waist - 0.010) < 1e-9);
    const Piece& band = piece(patternOf("circle-skirt"), "waistband");
    QVERIFY(std::abs(length(band, "bottom-left") + length(band, "bottom-right") - m.waist - 0.010) < 1e-12);
}

void tst_Garments::trousersHaveTheirEase() {
    const body::Measurements m;
    const TrouserLevels levels = trouserLevels(m, woman().body.landmarks);
    const Piece &front = piece(patternOf("trousers"), "front-left"), &back = piece(patternOf("trousers"), "back-right");
    QVERIFY(std::abs(2 * (widthAt(front, levels.hip) + widthAt(back, levels.hip)) - m.hip - 0.045) < micrometre);
    // The crotch point settles after the width: a thousandth of a millimetre is far below a pencil's line.
    QVERIFY(std::abs(widthAt(front, levels.thigh) + widthAt(back, levels.thigh) - m.thigh - 0.055) < 1e-5);
    double waist = 0;
    for (const Piece* panel : {&front, &back})
        waist += 2 * (length(*panel, "waist-side") + length(*panel, "waist-centre"));
    QVERIFY(std::abs(waist - m.waist - 0.010) < 1e-5);
}

void tst_Garments::matedCornersAreTrue_data() {
    QTest::addColumn<QString>("sample");
    QTest::addColumn<QStringList>("corners"); // piece:corner …, whose angles together make a straight line
    QTest::newRow("T-shirt, shoulder and neck")
        << "t-shirt" << QStringList{"front:neck-side-left", "back:neck-side-left"};
    QTest::newRow("T-shirt, shoulder and armhole")
        << "t-shirt" << QStringList{"front:shoulder-tip-left", "back:shoulder-tip-left"};
    QTest::newRow("T-shirt, underarm") << "t-shirt" << QStringList{"front:underarm-left", "back:underarm-left"};
    QTest::newRow("T-shirt, hem") << "t-shirt" << QStringList{"front:hem-side-left", "back:hem-side-left"};
    QTest::newRow("T-shirt, sleeve hem") << "t-shirt"
                                         << QStringList{"sleeve-left:bottom-front", "sleeve-left:bottom-back"};
    QTest::newRow("skirt, hem before") << "circle-skirt" << QStringList{"skirt-left:hem-front", "skirt-left:hem-front"};
    QTest::newRow("skirt, waist behind") << "circle-skirt"
                                         << QStringList{"skirt-left:waist-back", "skirt-left:waist-back"};
    QTest::newRow("trousers, waist at the side")
        << "trousers" << QStringList{"front-left:waist-side", "back-right:waist-side"};
    QTest::newRow("trousers, waist before")
        << "trousers" << QStringList{"front-left:waist-centre", "front-left:waist-centre"};
    QTest::newRow("trousers, waist behind")
        << "trousers" << QStringList{"back-right:waist-centre", "back-right:waist-centre"};
    QTest::newRow("trousers, front dart")
        << "trousers" << QStringList{"front-left:dart-side", "front-left:dart-centre"};
    QTest::newRow("trousers, back dart") << "trousers" << QStringList{"back-right:dart-side", "back-right:dart-centre"};
    QTest::newRow("trousers, crotch") << "trousers"
                                      << QStringList{"front-left:crotch-point", "back-right:crotch-point"};
    QTest::newRow("trousers, hem inside")
        << "trousers" << QStringList{"front-left:hem-inside", "back-right:hem-inside"};
    QTest::newRow("trousers, hem at the side")
        << "trousers" << QStringList{"front-left:hem-side", "back-right:hem-side"};
}

void tst_Garments::matedCornersAreTrue() {
    QFETCH(QString, sample);
    QFETCH(QStringList, corners);
    double sum = 0;
    for (const QString& corner : corners) {
        const std::string id = corner.section(':', 0, 0).toStdString(), name = corner.section(':', 1).toStdString();
        sum += cornerDegrees(piece(patternOf(sample.toStdString()), id), vertexId(id, name));
    }
    QVERIFY2(std::abs(sum - 180) < 3, qPrintable(QString::number(sum))); // the trade's tolerance
}

void tst_Garments::bodiesOfSmallScenesAreClosed() {
    for (const auto& mesh : {tableMesh(), cylinderMesh()}) {
        QVERIFY(geometry::isClosedManifold(mesh));
        QVERIFY(geometry::signedVolume(mesh) > 0);
    }
    // π r² h less what 128 flat sides cut off (0.04 %).
    QVERIFY(std::abs(geometry::signedVolume(cylinderMesh()) / (M_PI * 0.1 * 0.1 * 0.6) - 1) < 5e-4);
}

TOILE_TEST(tst_Garments)
#include "tst_Garments.moc"
