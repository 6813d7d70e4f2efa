// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/OffscreenGl.h"
#include "core/picture/RenderPicture.h"
#include "tests/Suite.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <optional>

using namespace toile;
using namespace toile::picture;

namespace {

constexpr Viewport small{200, 160};

struct Pixel {
    int r = 0, g = 0, b = 0;
    friend bool operator==(const Pixel&, const Pixel&) = default;
};
Pixel pixelAt(const Image& image, int x, int y) {
    const std::uint8_t* p = image.rgba.data() + (static_cast<std::size_t>(y) * image.width + x) * 4;
    return {p[0], p[1], p[2]};
}
bool isReddish(Pixel p) {
    return p.r > 1.3 * p.g && p.r > 1.3 * p.b;
}
bool isBluish(Pixel p) {
    return p.b > 1.3 * p.r && p.b > 1.1 * p.g;
}
bool isGreen(Pixel p) {
    return p.g > p.r + 60 && p.g > p.b + 60;
}
int saturation(Pixel p) {
    return std::max({p.r, p.g, p.b}) - std::min({p.r, p.g, p.b});
}

/// Flat squares across the view, each with its right side towards +z: id, middle, half width.
struct Square {
    std::string id;
    Vec3 middle;
    double half = 0.1;
};
simulation::Frame frameOf(const std::vector<Square>& squares) {
    simulation::FrameTopology topology;
    simulation::Frame frame;
    for (const auto& [id, m, h] : squares) {
        const int v = static_cast<int>(frame.positions.size()), t = static_cast<int>(topology.triangles.size());
        frame.positions.insert(frame.positions.end(),
                               {m + Vec3{-h, -h, 0}, m + Vec3{h, -h, 0}, m + Vec3{h, h, 0}, m + Vec3{-h, h, 0}});
        topology.triangles.insert(topology.triangles.end(), {{v, v + 1, v + 2}, {v, v + 2, v + 3}});
        topology.pieces.push_back({id, id, v, 4, t, 2});
    }
    topology.triangleRegion.assign(topology.triangles.size(), -1);
    frame.topology = Shared(std::move(topology));
    return frame;
}

RenderScene sceneOf(const std::vector<Square>& squares) {
    RenderScene scene;
    scene.frame = Shared(frameOf(squares));
    scene.pieceColours = {{"red", {0.85f, 0.15f, 0.12f}}, {"blue", {0.15f, 0.25f, 0.85f}}};
    scene.options.floor = false;
    scene.options.shadows = false;
    return scene;
}

void addSeam(RenderScene& scene, std::vector<std::array<int, 2>> pairs) {
    simulation::Frame frame = **scene.frame;
    simulation::FrameTopology topology = *frame.topology;
    topology.seams = {std::move(pairs)};
    frame.topology = Shared(std::move(topology));
    scene.frame = Shared(std::move(frame));
}

const Camera fromFront{.target = {0, 0, 0}, .distance = 1, .fovY = 0.5};
const Camera fromBehind = lookingFrom(ViewDirection::back, fromFront);

} // namespace

class tst_Rendering : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void anEmptySceneIsASoftGradient();
    void theRightSideHasTheColourOfTheFabric();
    void theWrongSideIsDuller();
    void severalPliesShowARightSideToEitherSide();
    void theNearerPieceHidesTheFarther();
    void theOrderOfPiecesDoesNotMatter();
    void whatIsProjectedIsDrawnThere();
    void aSelectedPieceLooksDifferent();
    void aRegionIsTinted();
    void seamsAreDrawnInTheirColour();
    void seamsBehindThePieceAreHidden();
    void seamsUnderALayerAreHiddenWhereOneLooksClosely();
    void seamsOfWhatIsSeenSlantwiseAreWhole();
    void meshLinesAppearWhenAskedFor();
    void overlayIsSeenThroughEverything();
    void bodyAndClothCanBeLeftOut();
    void aNewFrameOfTheSameTopologyMovesThePicture();
    void changedTopologyIsDrawn();
    void shadowsFallOnTheFloor();
    void brokenPositionsDoNotStopThePicture();
    void theSameSceneGivesTheSamePicture();
    void picturesOfImpossibleSizeAreRefused();
    void stillPicturesHaveSmoothEdges();
    void aMeshBecomesAPngFile();

private:
    Image draw(const RenderScene& scene, const Camera& camera = fromFront) {
        auto image = gl_->render(scene, camera, small);
        if (!image) qFatal("%s", image.error().text.c_str());
        return *image;
    }
    Pixel middleOf(const RenderScene& scene, const Camera& camera = fromFront) {
        return pixelAt(draw(scene, camera), small.width / 2, small.height / 2);
    }

    std::optional<OffscreenGl> gl_;
};

void tst_Rendering::initTestCase() {
    auto gl = OffscreenGl::create();
    if (!gl) QSKIP(("NOT RUN: " + gl.error().text).c_str());
    gl_.emplace(std::move(*gl));
    QVERIFY(!gl_->deviceName().empty());
}

void tst_Rendering::anEmptySceneIsASoftGradient() {
    const Image image = draw({});
    QVERIFY(pixelAt(image, 100, 5).g > pixelAt(image, 100, 155).g + 20); // lighter at the top
    for (int y = 1; y < small.height; ++y) {
        const int step = std::abs(pixelAt(image, 100, y).g - pixelAt(image, 100, y - 1).g);
        QVERIFY(step <= 2); // one step of the gradient, one of the noise that hides bands
    }
}

void tst_Rendering::theRightSideHasTheColourOfTheFabric() {
    QVERIFY(isReddish(middleOf(sceneOf({{"red", {}}}))));
    QVERIFY(isBluish(middleOf(sceneOf({{"blue", {}}}))));
}

void tst_Rendering::theWrongSideIsDuller() {
    const RenderScene scene = sceneOf({{"red", {}}});
    const Pixel right = middleOf(scene), wrong = middleOf(scene, fromBehind);
    QVERIFY2(saturation(wrong) < 0.7 * saturation(right),
             qPrintable(QString("%1 against %2").arg(saturation(wrong)).arg(saturation(right))));
    RenderScene white = scene; // no colour to lose: darker instead
    white.pieceColours["red"] = {0.95f, 0.95f, 0.95f};
    QVERIFY(middleOf(white, fromBehind).g < middleOf(white).g - 25);
}

void tst_Rendering::severalPliesShowARightSideToEitherSide() {
    RenderScene scene = sceneOf({{"red", {}}});
    const Pixel front = middleOf(scene), wrong = middleOf(scene, fromBehind);
    simulation::Frame frame = **scene.frame;
    simulation::FrameTopology topology = *frame.topology;
    topology.pieces[0].rightSidesOnly = true;
    frame.topology = Shared(topology);
    scene.frame = Shared(frame);
    QVERIFY(middleOf(scene) == front);
    QVERIFY(saturation(middleOf(scene, fromBehind)) > 1.3 * saturation(wrong));
    scene.selectedPiece = "red";
    const Pixel selected = middleOf(scene, fromBehind);
    scene.selectedPiece = "";
    QVERIFY(selected != middleOf(scene, fromBehind)); // still told apart
}

void tst_Rendering::theNearerPieceHidesTheFarther() {
    const RenderScene scene = sceneOf({{"red", {0, 0, 0.1}}, {"blue", {0, 0, -0.1}}});
    QVERIFY(isReddish(middleOf(scene)));
    QVERIFY(!isReddish(middleOf(scene, fromBehind)));
}

void tst_Rendering::theOrderOfPiecesDoesNotMatter() {
    QVERIFY(isReddish(middleOf(sceneOf({{"blue", {0, 0, -0.1}}, {"red", {0, 0, 0.1}}}))));
    QVERIFY(isBluish(middleOf(sceneOf({{"red", {0, 0, -0.001}}, {"blue", {0, 0, 0.001}}})))); // a layer of 2 mm
}

/// The middle of the red pixels is where worldToScreen says, for cameras from all sides.
void tst_Rendering::whatIsProjectedIsDrawnThere() {
    const Vec3 place{0.13, 0.06, 0.05};
    const RenderScene scene = sceneOf({{"red", place, 0.01}});
    for (const double yaw : {-0.6, 0.0, 0.5})
        for (const double pitch : {-0.5, 0.0, 0.7}) {
            const Camera camera{.target = {0.02, -0.01, 0}, .distance = 1, .yaw = yaw, .pitch = pitch, .fovY = 0.5};
            const Image image = draw(scene, camera);
            Vec2 sum;
            int count = 0;
            for (int y = 0; y < small.height; ++y)
                for (int x = 0; x < small.width; ++x)
                    if (isReddish(pixelAt(image, x, y))) {
                        sum += {x + 0.5, y + 0.5};
                        ++count;
                    }
            QVERIFY(count > 10);
            const auto seen = worldToScreen(camera, small, place);
            QVERIFY(distance(sum / count, seen->pixel) < 0.5); // pixels of a small figure, counted whole
        }
}

void tst_Rendering::aSelectedPieceLooksDifferent() {
    RenderScene scene = sceneOf({{"blue", {}}});
    const auto edge = worldToScreen(fromFront, small, {0.1, 0.02, 0})->pixel;
    const auto atEdge = [&] { return pixelAt(draw(scene), static_cast<int>(edge.x), static_cast<int>(edge.y)); };
    const Pixel inside = middleOf(scene);
    scene.selectedPiece = "blue";
    QVERIFY(middleOf(scene).r > inside.r + 8); // a touch of the mark's colour, and a line round it
    QVERIFY(atEdge() == (Pixel{255, 168, 56}));
    scene.selectedPiece = "another";
    QVERIFY(middleOf(scene) == inside);
    QVERIFY(atEdge() != (Pixel{255, 168, 56}));
}

void tst_Rendering::aRegionIsTinted() {
    RenderScene scene = sceneOf({{"blue", {}}});
    simulation::Frame frame = **scene.frame;
    simulation::FrameTopology topology = *frame.topology;
    topology.triangleRegion = {0, 0};
    frame.topology = Shared(std::move(topology));
    scene.frame = Shared(std::move(frame));
    const Pixel before = middleOf(scene);
    QVERIFY(isBluish(before));
    scene.options.regions = true;
    QVERIFY(!isBluish(middleOf(scene)));
}

void tst_Rendering::seamsAreDrawnInTheirColour() {
    RenderScene scene = sceneOf({{"red", {-0.105, 0, 0}}, {"blue", {0.105, 0, 0}}}); // 10 mm apart
    addSeam(scene, {{1, 4}, {2, 7}});
    scene.seamColours = {{0.1f, 0.9f, 0.1f}};
    const auto edge = worldToScreen(fromFront, small, {-0.005, 0.02, 0})->pixel;
    const auto greenAtEdge = [&] {
        const Image image = draw(scene);
        bool found = false;
        for (int dx = -2; dx <= 2; ++dx)
            found = found || isGreen(pixelAt(image, static_cast<int>(edge.x) + dx, static_cast<int>(edge.y)));
        return found;
    };
    QVERIFY(greenAtEdge());
    scene.options.seams = false;
    QVERIFY(!greenAtEdge());
}

void tst_Rendering::seamsBehindThePieceAreHidden() {
    RenderScene scene = sceneOf({{"red", {0, 0, 0.01}, 0.15}, {"blue", {0, 0, 0}}});
    addSeam(scene, {{4, 6}, {5, 7}});
    RenderScene without = scene;
    without.options.seams = false;
    QVERIFY(draw(scene) == draw(without));
    QVERIFY(draw(scene, fromBehind) != draw(without, fromBehind));
}

void tst_Rendering::seamsUnderALayerAreHiddenWhereOneLooksClosely() {
    RenderScene scene = sceneOf({{"red", {0, 0, 0.001}, 0.02}, {"blue", {}, 0.01}});
    addSeam(scene, {{4, 4}, {6, 6}}); // along the diagonal
    RenderScene without = scene;
    without.options.seams = false;
    const Camera close{.target = {}, .distance = 0.1, .fovY = 0.5};
    QVERIFY(draw(scene, close) == draw(without, close));
    const Camera behind = lookingFrom(ViewDirection::back, close);
    QVERIFY(draw(scene, behind) != draw(without, behind));
}

void tst_Rendering::seamsOfWhatIsSeenSlantwiseAreWhole() {
    RenderScene scene = sceneOf({{"blue", {}, 0.01}});
    addSeam(scene, {{0, 0}, {2, 2}}); // along the diagonal
    scene.seamColours = {{0.1f, 0.9f, 0.1f}};
    RenderScene onTop = scene;
    onTop.options.seams = false;
    onTop.overlay = {
        {.points = {{-0.01, -0.01, 0}, {0.01, 0.01, 0}}, .colour = {0.1f, 0.9f, 0.1f}, .width = 1.8, .onTop = true}};
    for (const double distance : {0.05, 0.1, 0.3, 1.0}) {
        const Camera slantwise{.target = {}, .distance = distance, .yaw = 1.2, .fovY = 0.5};
        const auto green = [&](const RenderScene& s) {
            const Image image = draw(s, slantwise);
            int count = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) count += isGreen(pixelAt(image, x, y)) ? 1 : 0;
            return count;
        };
        QVERIFY(green(scene) > 0.9 * green(onTop));
    }
}

void tst_Rendering::meshLinesAppearWhenAskedFor() {
    RenderScene scene = sceneOf({{"red", {}}});
    simulation::Frame frame = **scene.frame;
    simulation::FrameTopology topology = *frame.topology;
    topology.meshLines = {{0, 2}};
    frame.topology = Shared(std::move(topology));
    scene.frame = Shared(frame);
    const auto onDiagonal = [&] { return pixelAt(draw(scene), 100, 79); }; // right and above of the middle: on the line
    const Pixel before = onDiagonal();
    scene.options.meshLines = true;
    QVERIFY(onDiagonal().r < before.r - 25);
}

void tst_Rendering::overlayIsSeenThroughEverything() {
    RenderScene scene = sceneOf({{"red", {}}});
    Stroke stroke{{{-0.1, 0, -0.2}, {0.1, 0, -0.2}}, {0, 1, 0}, 4, true};
    scene.overlay = {stroke};
    QVERIFY(middleOf(scene) == (Pixel{0, 255, 0}));
    scene.overlay[0].onTop = false;
    QVERIFY(isReddish(middleOf(scene)));
}

void tst_Rendering::bodyAndClothCanBeLeftOut() {
    RenderScene scene = sceneOf({{"red", {}}});
    scene.body = Shared(body::Body{.mesh = {{{-0.1, -0.1, 0.1}, {0.1, -0.1, 0.1}, {0, 0.2, 0.1}}, {{0, 1, 2}}}});
    const Pixel body = middleOf(scene);
    QVERIFY(!isReddish(body));
    scene.options.body = false;
    QVERIFY(isReddish(middleOf(scene)));
    scene.options.cloth = false;
    const Pixel nothing = middleOf(scene);
    QVERIFY(!isReddish(nothing) && nothing != body);
}

void tst_Rendering::aNewFrameOfTheSameTopologyMovesThePicture() {
    RenderScene scene = sceneOf({{"red", {}}});
    QVERIFY(isReddish(middleOf(scene)));
    simulation::Frame moved = **scene.frame;
    for (Vec3& p : moved.positions) p += {0.3, 0, 0};
    scene.frame = Shared(moved);
    QVERIFY(!isReddish(middleOf(scene)));
}

void tst_Rendering::changedTopologyIsDrawn() {
    QVERIFY(isReddish(middleOf(sceneOf({{"red", {}}}))));
    QVERIFY(isBluish(middleOf(sceneOf({{"red", {0.3, 0, 0}}, {"blue", {}}}))));
    QVERIFY(!isBluish(middleOf({})));
}

void tst_Rendering::shadowsFallOnTheFloor() {
    RenderScene scene = sceneOf({{"red", {0, 0.3, 0}, 0.2}});
    scene.options.floor = true;
    const Camera above{.target = {0, 0, 0}, .distance = 3, .pitch = 0.9, .fovY = 0.6};
    const auto darkness = [&](bool shadows) {
        scene.options.shadows = shadows;
        const Image image = draw(scene, above);
        long sum = 0;
        for (const std::uint8_t value : image.rgba) sum += 255 - value;
        return sum;
    };
    const long without = darkness(false), with = darkness(true);
    QVERIFY2(with > without + 20000,
             qPrintable(QString("%1 %2").arg(without).arg(with))); // ≥ 200 pixels by 30 in r, g, b
}

void tst_Rendering::brokenPositionsDoNotStopThePicture() {
    RenderScene scene = sceneOf({{"red", {}}, {"blue", {0.3, 0, 0}}});
    simulation::Frame frame = **scene.frame;
    frame.positions[5] = {std::nan(""), 0, 0};
    scene.frame = Shared(frame);
    QVERIFY(isReddish(middleOf(scene)));
}

void tst_Rendering::theSameSceneGivesTheSamePicture() {
    const RenderScene scene = sceneOf({{"red", {}}});
    QVERIFY(draw(scene) == draw(scene));
    auto other = OffscreenGl::create();
    QVERIFY(other);
    QVERIFY(*other->render(scene, fromFront, small) == draw(scene));
}

void tst_Rendering::picturesOfImpossibleSizeAreRefused() {
    for (const Viewport size : {Viewport{0, 100}, Viewport{100, -1}, Viewport{100000, 10}}) {
        const auto image = gl_->render({}, fromFront, size);
        QVERIFY(!image);
        QVERIFY(!image.error().text.empty());
    }
    QVERIFY(gl_->render({}, fromFront, small)); // and drawing goes on
}

void tst_Rendering::stillPicturesHaveSmoothEdges() {
    const auto image =
        renderPicture(sceneOf({{"red", {}}}), {.target = {}, .distance = 1, .yaw = 0.2, .pitch = 0.1}, 200, 160);
    QVERIFY(image);
    QCOMPARE(image->width, 200);
    // Between background and red there are mixtures: more than two kinds of jump along a row.
    const Pixel inside = pixelAt(*image, 100, 80);
    int mixed = 0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) {
            const Pixel p = pixelAt(*image, x, y);
            if (saturation(p) > saturation(inside) / 5 && saturation(p) < saturation(inside) * 4 / 5) ++mixed;
        }
    QVERIFY(mixed > 50);
}

void tst_Rendering::aMeshBecomesAPngFile() {
    const QTemporaryDir folder;
    const auto path = std::filesystem::path(folder.filePath("mesh.png").toStdString());
    QVERIFY(renderMesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, path, true));
    QVERIFY(std::filesystem::file_size(path) > 1000);
}

TOILE_TEST(tst_Rendering)
#include "tst_Rendering.moc"
