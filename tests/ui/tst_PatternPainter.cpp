// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "tests/Suite.h"
#include "ui/pattern/Colours.h"
#include "ui/pattern/NamePlace.h"
#include "ui/pattern/PatternPainter.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

namespace {

QImage paintedImage(const document::Document& document, const MeshLines& mesh = {}, const Selection& selection = {},
                    const Overlay& overlay = {}, PatternLook look = {}) {
    const FlatPattern flat = flattened(document.pattern);
    QImage image(400, 400, QImage::Format_ARGB32);
    QPainter painter(&image);
    paint(painter, fitted({{}, 1000, {400, 400}}, boundsOf(flat), 40),
          {document.pattern, flat, mesh, selection, {}, overlay, look});
    return image;
}

int different(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

} // namespace

class tst_PatternPainter : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void piecesAreSeen();
    void meshLinesAreSeenUnlessTooDense();
    void regionsAreTinted();
    void seamsAreColoured();
    void cutLinesAreSeenUnlessTurnedOff();
    void pinsAreSeenAlsoWhilePointsAre();
    void selectionStandsOut();
    void overlayStandsOut();
    void namesHideNoDart();
    void gridStepsAreOneTwoFive();
    void chineseIsNotBoxes();
};

void tst_PatternPainter::piecesAreSeen() {
    QVERIFY(different(paintedImage(twoRectangles()), paintedImage({})) > 400 * 40);
}

void tst_PatternPainter::meshLinesAreSeenUnlessTooDense() {
    MeshLines mesh(2);
    for (int i = -4; i <= 4; ++i) mesh[0].lines.emplace_back(i * 0.02, -0.15, i * 0.02, 0.15);
    mesh[0].spacing = 0.02;
    QVERIFY(different(paintedImage(twoRectangles(), mesh), paintedImage(twoRectangles())) > 300);
    mesh[0].spacing = 1e-4; // a tenth of a pixel
    QCOMPARE(different(paintedImage(twoRectangles(), mesh), paintedImage(twoRectangles())), 0);
}

void tst_PatternPainter::regionsAreTinted() {
    document::Document document = twoRectangles();
    pattern::Piece piece = *document.pattern.pieces[0];
    pattern::Region region;
    region.id = pattern::RegionId("r99");
    region.outline = {{-0.05, -0.05}, {0.05, -0.05}, {0.05, 0.05}, {-0.05, 0.05}};
    piece.regions.push_back(region);
    document.pattern.pieces[0] = Shared<pattern::Piece>(piece);
    QVERIFY(different(paintedImage(document), paintedImage(twoRectangles())) > 1000);
    QVERIFY(colours::regionTint(1) != colours::regionTint(2));
}

void tst_PatternPainter::seamsAreColoured() {
    document::Document document = twoRectangles();
    pattern::Seam seam;
    seam.id = pattern::SeamId("s99");
    seam.sides[0] = {{document.pattern.pieces[0]->id, document.pattern.pieces[0]->outline.edges[1].id}};
    seam.sides[1] = {{document.pattern.pieces[1]->id, document.pattern.pieces[1]->outline.edges[3].id, 0, 1, true}};
    document.pattern.seams.push_back(seam);
    QVERIFY(different(paintedImage(document), paintedImage(twoRectangles())) > 300);
    QVERIFY(different(paintedImage(document, {}, {seam.id}), paintedImage(document)) > 300); // links to the partner
}

void tst_PatternPainter::cutLinesAreSeenUnlessTurnedOff() {
    PatternLook without;
    without.cutLines = false;
    QVERIFY(different(paintedImage(twoRectangles()), paintedImage(twoRectangles(), {}, {}, {}, without)) > 1000);
}

void tst_PatternPainter::pinsAreSeenAlsoWhilePointsAre() {
    document::Document document = twoRectangles();
    const pattern::Piece& piece = *document.pattern.pieces[0];
    document.pattern.pins.push_back({pattern::PinId("n1"), piece.id, piece.outline.vertices[2].id});
    document::Document toBody = document;
    toBody.pattern.pins[0].toBody = true;
    for (const bool points : {false, true}) {
        PatternLook look;
        look.vertices = points;
        QVERIFY(different(paintedImage(toBody, {}, {}, {}, look), paintedImage(document, {}, {}, {}, look)) > 80);
        QVERIFY(different(paintedImage(document, {}, {}, {}, look), paintedImage(twoRectangles(), {}, {}, {}, look)) >
                80);
    }
}

void tst_PatternPainter::selectionStandsOut() {
    const document::Document document = twoRectangles();
    QVERIFY(different(paintedImage(document, {}, {document.pattern.pieces[0]->id}), paintedImage(document)) > 300);
}

void tst_PatternPainter::overlayStandsOut() {
    Overlay overlay;
    overlay.labels.push_back({{0, 0}, QStringLiteral("250.0 mm")});
    QVERIFY(different(paintedImage(twoRectangles(), {}, {}, overlay), paintedImage(twoRectangles())) > 200);
}

void tst_PatternPainter::namesHideNoDart() {
    document::Document document = twoRectangles();
    const FlatPattern plain = flattened(document.pattern);
    const ViewTransform view = fitted({{}, 1000, {400, 400}}, boundsOf(plain), 40);
    const QSizeF size(50, 18);
    const QRectF wished = placeOfName(view, plain.pieces[0], {}, size);
    QVERIFY(covers(plain.pieces[0], view.toPattern(wished.center())));
    // A hole just where the name was: it goes beside it.
    FlatPiece holed = plain.pieces[0];
    const Vec2 middle = view.toPattern(wished.center());
    const std::vector<Vec2> corners{middle, middle + Vec2{0.004, 0.02}, middle + Vec2{0, 0.04}};
    holed.holes.push_back({{{corners[0], corners[1]}, {corners[1], corners[2]}, {corners[2], corners[0]}}, corners});
    const QRectF moved = placeOfName(view, holed, {}, size);
    QVERIFY(covers(holed, view.toPattern(moved.center())));
    for (const Vec2 corner : corners) QVERIFY(!moved.contains(view.toScreen(corner)));
    // A piece smaller than its name has it beneath.
    const QRectF below = placeOfName(view, plain.pieces[0], {}, {4000, 18});
    QVERIFY(below.top() > view.toScreen(boundsOf(plain.pieces[0]).low).y());
}

void tst_PatternPainter::gridStepsAreOneTwoFive() {
    for (const auto& [scale, step] : {std::pair{1000.0, 0.02}, {400.0, 0.05}, {2000.0, 0.01}, {100.0, 0.2}})
        QCOMPARE(gridStep({{}, scale, {100, 100}}, 12), step);
}

void tst_PatternPainter::chineseIsNotBoxes() {
    const auto picture = [](const QString& text) {
        QImage image(60, 40, QImage::Format_ARGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        QFont font = painter.font();
        font.setPixelSize(24);
        painter.setFont(font);
        painter.drawText(image.rect(), Qt::AlignCenter, text);
        return image;
    };
    QVERIFY(picture(QStringLiteral("片")) != picture(QStringLiteral("袖"))); // boxes would be alike
    QVERIFY(picture(QStringLiteral("片")) != picture(QStringLiteral(" ")));
}

TOILE_TEST(tst_PatternPainter, QApplication)
#include "tst_PatternPainter.moc"
