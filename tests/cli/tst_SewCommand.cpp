// SPDX-License-Identifier: GPL-3.0-or-later
#include "Png.h" // before ours: moc 6.4 stumbles over <compare> as the first header

#include "Program.h"
#include "core/io/BodyImport.h"
#include "core/io/ToileFile.h"
#include "samples/SmallScenes.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <algorithm>
#include <csignal>

using namespace toile;

namespace {

/// An upright box with its foot on the floor and its middle on the y axis.
body::Body box(double width, double depth) {
    body::Body body{"box", {}, {}, {}};
    for (const double x : {-width / 2, width / 2})
        for (const double y : {0.0, 2.0})
            for (const double z : {-depth / 2, depth / 2}) body.mesh.vertices.push_back({x, y, z});
    body.mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                           {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    return body;
}

} // namespace

class tst_SewCommand : public QObject {
    Q_OBJECT
private slots:
    void init();
    void twoSquaresAreSewn();
    void theReportHasTheKeysThatArePromised();
    void whatIsNotThereIsNull();
    void everyDrapeFormatIsWritten();
    void framesAreKeptAsAPointCacheOrAFolder();
    void framesOfAnotherRunAreNotMixedIn();
    void theAvatarMovesOnceTheClothHangs();
    void motionsThatCannotBeAreRefused();
    void aPictureIsNotBlank();
    void equalRunsGiveEqualBits();
    void aFinerMeshGetsMoreSubsteps();
    void aFineGarmentIsSewnOnItsOwnMeshFirst();
    void aCoarserMeshIsNoRefinement();
    void selfContactCanBeAskedForWhereTheDocumentDoesNot();
    void quietSaysNothing();
    void aSeamHeldOpenIsAGoalMissed();
    void aLimitThatIsTooShortIsAGoalMissed();
    void aStartInTheBodyIsWarnedOfRefusedOrArranged();
    void everyMethodDrapesWhatXpbdHasSewn_data();
    void everyMethodDrapesWhatXpbdHasSewn();
    void thePaperGoesItsOwnWayFromEndToEnd();
    void staticsKnowsNoTime();
    void theReportSaysHowManyThreadsThereWere();
    void aMissingFolderIsSaidAndNothingIsWritten();
    void noResultTakesThePlaceOfAnInputOrOfAnother_data();
    void noResultTakesThePlaceOfAnInputOrOfAnother();
    void whatCannotBeWrittenIsSaidBeforeTheRun_data();
    void whatCannotBeWrittenIsSaidBeforeTheRun();
    void namesMayEndInCapitals();
    void aCheckpointMayTakeThePlaceOfTheOneItGoesOnFrom();
    void aBrokenDocumentIsRefused();
    void anInterruptLeavesNothingBehind_data();
    void anInterruptLeavesNothingBehind();
    void aRunThatIsToldToEndKeepsItsCheckpoint_data() { anInterruptLeavesNothingBehind_data(); }
    void aRunThatIsToldToEndKeepsItsCheckpoint();
    void aStoppedRunGoesOnFromItsCheckpoint();
    void wrongUsage_data();
    void wrongUsage();

private:
    [[nodiscard]] QString in(const char* name) const { return folder_->filePath(name); }
    [[nodiscard]] Json report() const { return jsonOf(contentOf(in("sew.json"))); }
    /// A document of two squares that are 0.2 m apart, with a body between them.
    [[nodiscard]] QString squaresWith(const body::Body& body) const {
        document::Document document = samples::twoSquares();
        document.avatarFile = "body.glb";
        document.scene.damping = 2; // so that it comes to rest against the body
        const bool written = io::writeBody(in("body.glb").toStdString(), body).has_value() &&
                             io::writeToile(document, in("squares.toile").toStdString()).has_value();
        return written ? in("squares.toile") : QString();
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

void tst_SewCommand::init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
}

void tst_SewCommand::twoSquaresAreSewn() {
    const Finished finished =
        run({"sew", sample("two-squares.toile"), "--out", in("drape.glb"), "--report", in("sew.json")});
    QVERIFY2(finished.status == 0, qPrintable(finished.err));
    QVERIFY(finished.out.contains("1 of 1 seams closed"));
    QVERIFY(contentOf(in("drape.glb")).startsWith("glTF"));
    const Json json = report();
    const Json& seam = json.find("seams")->asArray()->front();
    QCOMPARE(*seam.find("closed")->asBool(), true);
    QCOMPARE(*seam.find("maximumGap")->asNumber(), 0.0);
    QVERIFY(*seam.find("gapAtMergeMaximum")->asNumber() <= 0.5e-3);
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files).size(), 2);
}

void tst_SewCommand::theReportHasTheKeysThatArePromised() {
    QVERIFY(
        run({"sew", sample("tube.toile"), "--spacing", "40", "--seconds", "1", "--report", in("sew.json")}).status >=
        0);
    const Json json = report();
    QCOMPARE(missingKeys(json, {"document",      "avatar",    "method",           "step",
                                "threads",       "particles", "springs",          "seams",
                                "worn",          "contact",   "clampedCells",     "finishDisplacementMaximum",
                                "finishSeconds", "strain",    "simulatedSeconds", "cpuSeconds",
                                "wallSeconds",   "steps",     "atRest",           "residual",
                                "energy",        "peakBytes", "resultHash",       "stages",
                                "leftOut",       "warnings"}),
             QString());
    QCOMPARE(missingKeys(*json.find("springs"), {"structural", "shear", "bending", "twist"}), QString());
    for (const Json& seam : *json.find("seams")->asArray())
        QCOMPARE(missingKeys(seam, {"name", "pairs", "initialGap", "gapAtMergeMaximum", "maximumGap", "meanGap",
                                    "merged", "closed"}),
                 QString());
    QCOMPARE(missingKeys(*json.find("worn"), {"verdict", "openings", "rightSideOut", "landmarks"}), QString());
    QCOMPARE(missingKeys(*json.find("contact"), {"bodyPenetrationMaximum", "bodyClearanceMinimum", "selfIntersections",
                                                 "bodyIntersections", "guarantee"}),
             QString());
    QCOMPARE(missingKeys(*json.find("strain"), {"warpMaximum", "weftMaximum", "shearMaximum", "rms"}), QString());
    QCOMPARE(missingKeys(*json.find("curvature"), {"rms", "alternating"}), QString());
    QCOMPARE(missingKeys(*json.find("energy"), {"kinetic", "gravity", "elastic"}), QString());
    for (const Json& stage : *json.find("stages")->asArray())
        QCOMPARE(missingKeys(stage, {"name", "seconds", "share"}), QString());
    for (const Json& left : *json.find("leftOut")->asArray()) QCOMPARE(missingKeys(left, {"stage", "why"}), QString());
    QVERIFY(*json.find("peakBytes")->asNumber() > 1e6); // a program holds more than a megabyte
    QCOMPARE(json.find("resultHash")->asString()->size(), std::size_t(64));
    QCOMPARE(*json.find("method")->asString(), std::string("xpbd"));
}

void tst_SewCommand::whatIsNotThereIsNull() {
    QCOMPARE(run({"sew", sample("two-squares.toile"), "--seconds", "3", "--report", in("sew.json")}).status, 0);
    const Json json = report();
    QVERIFY(json.find("avatar")->isNull());
    QVERIFY(json.find("worn")->find("verdict")->isNull());
    QVERIFY(!json.find("worn")->find("why")->asArray()->empty()); // null with a reason
    QVERIFY(json.find("contact")->find("bodyClearanceMinimum")->isNull());
    QVERIFY(json.find("residual")->isNull()); // a run of so many seconds has no finish
    QVERIFY(json.find("finishDisplacementMaximum")->isNull());
    QVERIFY(json.find("finishSeconds")->isNull());
    QVERIFY(json.find("coarse")->find("particles")->isNull());
    QVERIFY(!contentOf(in("sew.json")).contains("nan"));
}

void tst_SewCommand::everyDrapeFormatIsWritten() {
    for (const char* file : {"drape.glb", "drape.obj", "drape.ply", "drape.stl"}) {
        QCOMPARE(run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--out", in(file)}).status,
                 3); // not sewn yet
        QVERIFY2(contentOf(in(file)).size() > 1000, file);
    }
}

void tst_SewCommand::framesAreKeptAsAPointCacheOrAFolder() {
    QCOMPARE(run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("cache.pc2")}).status,
             3); // not sewn yet
    QCOMPARE(run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("frames"), "--out",
                  in("drape.obj"), "--report", in("sew.json")})
                 .status,
             3);
    const QStringList frames = QDir(in("frames")).entryList(QDir::Files);
    QCOMPARE(frames.size(), 7); // the start and six steps
    QCOMPARE(contentOf(in("frames") + "/frame-00006.obj"), contentOf(in("drape.obj")));
    QCOMPARE(*report().find("frames")->find("count")->asNumber(), 7.0);
    const qsizetype points = contentOf(in("drape.obj")).count("\nv ");
    QCOMPARE(contentOf(in("cache.pc2")).size(), 32 + 7 * points * 12);
}

void tst_SewCommand::theAvatarMovesOnceTheClothHangs() {
    const QStringList sheet{
        "sew",         sample("sheet-two-corners.toile"), "--spacing", "100", "--limit", "0.1", "--quiet", "--report",
        in("sew.json")};
    body::Body body = box(0.2, 0.2);
    QVERIFY(QDir().mkpath(in("poses")));
    QVERIFY(io::writeBody(in("box.glb").toStdString(), body).has_value());
    QVERIFY(io::writeBody(in("poses/a.glb").toStdString(), body).has_value());
    for (Vec3& v : body.mesh.vertices) v.y += 0.1;
    QVERIFY(io::writeBody(in("poses/b.glb").toStdString(), body).has_value());
    const Finished pushed =
        run(sheet + QStringList{"--avatar", in("box.glb"), "--motion", in("poses"), "--motion-step", "0.1"});
    QVERIFY2(pushed.out.contains("the body moved for 0.10 s, at 1.0 m/s at most"), qPrintable(pushed.out));
    QJsonObject motion = QJsonDocument::fromJson(contentOf(in("sew.json"))).object()["motion"].toObject();
    QCOMPARE(motion["steps"].toInt(), 6);

    const Finished lifted = run(
        sheet + QStringList{"--avatar", sample("bodies/mannequin-42.glb"), "--lift-arms", "20", "--lift-time", "0.2"});
    QVERIFY2(lifted.out.contains("the body moved for 0.20 s"), qPrintable(lifted.out + lifted.err));
    motion = QJsonDocument::fromJson(contentOf(in("sew.json"))).object()["motion"].toObject();
    QCOMPARE(motion["steps"].toInt(), 12);
    QVERIFY(motion["bodySpeedMaximum"].toDouble() > 0.5);
}

void tst_SewCommand::motionsThatCannotBeAreRefused() {
    const QStringList sheet{"sew", sample("sheet-two-corners.toile"), "--spacing", "100", "--limit", "0.1"};
    const Finished bare = run(sheet + QStringList{"--lift-arms", "20"});
    QCOMPARE(bare.status, 1);
    QVERIFY2(bare.err.contains("no avatar that could move"), qPrintable(bare.err));
    const Finished both = run(sheet + QStringList{"--lift-arms", "20", "--motion", in("poses")});
    QCOMPARE(both.status, 2);
    const Finished kept = run(sheet + QStringList{"--avatar", sample("bodies/mannequin-42.glb"), "--lift-arms", "20",
                                                  "--checkpoint", in("point")});
    QCOMPARE(kept.status, 2);
}

void tst_SewCommand::framesOfAnotherRunAreNotMixedIn() {
    QVERIFY(run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("frames")}).status == 3);
    const Finished again = run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("frames")});
    QCOMPARE(again.status, 1);
    QVERIFY2(again.err.contains("frames of another run"), qPrintable(again.err));
}

void tst_SewCommand::aPictureIsNotBlank() {
    const Finished finished = run(
        {"sew", "--picture", in("front.png") + "," + in("back.png"), sample("two-squares.toile"), "--seconds", "3"});
    QVERIFY2(finished.status == 0, qPrintable(finished.err));
    QVERIFY(coloursIn(in("front.png")) > 100); // shaded cloth before a ground that is no plain colour
    QVERIFY(coloursIn(in("back.png")) > 100);
}

void tst_SewCommand::equalRunsGiveEqualBits() {
    QStringList hashes;
    for (const QStringList& more : {QStringList{}, QStringList{}, QStringList{"--threads", "4", "--deterministic"}}) {
        QVERIFY(run(QStringList{"sew", sample("two-squares.toile"), "--report", in("sew.json")} + more).status == 0);
        hashes << QString::fromStdString(*report().find("resultHash")->asString());
    }
    QCOMPARE(hashes[1], hashes[0]);
    QCOMPARE(hashes[2], hashes[0]);
}

/// A document that asks for 30 substeps on its own mesh of 100 mm.
void tst_SewCommand::aFinerMeshGetsMoreSubsteps() {
    document::Document sheet = samples::squareSheet(samples::SheetPins::oneEdge);
    pattern::Piece piece = *sheet.pattern.pieces[0];
    piece.spacing = 0.1;
    sheet.pattern.pieces[0] = piece;
    sheet.scene.substeps = 30;
    QVERIFY(io::writeToile(sheet, in("sheet.toile").toStdString()).has_value());
    const auto substeps = [&](const QStringList& options) {
        run(QStringList{"sew", in("sheet.toile"), "--seconds", "0.05", "--report", in("sew.json")} + options);
        return *report().find("substeps")->asNumber();
    };
    QCOMPARE(substeps({}), 30.0);
    QCOMPARE(substeps({"--spacing", "40"}), 75.0);
    QCOMPARE(substeps({"--spacing", "200"}), 30.0); // coarser: not fewer
    QCOMPARE(substeps({"--spacing", "40", "--substeps", "20"}), 20.0);
    QVERIFY(substeps({"--substeps", "auto"}) < 30);
}

void tst_SewCommand::aFineGarmentIsSewnOnItsOwnMeshFirst() {
    const auto particles = [&](const QStringList& options) {
        const Finished finished =
            run(QStringList{"sew", sample("two-squares.toile"), "--report", in("sew.json")} + options);
        return finished.status == 0 ? *report().find("particles")->asNumber() : -1;
    };
    const double own = particles({}), fine = particles({"--spacing", "10"});
    QVERIFY(own > 0 && fine > own);
    QCOMPARE(particles({"--spacing", "10", "--refine"}), fine);
    const Json json = report();
    const Json& coarse = *json.find("coarse");
    QCOMPARE(*coarse.find("particles")->asNumber(), own);
    QCOMPARE(*coarse.find("ending")->asString(), std::string("at rest"));
    QVERIFY(*coarse.find("simulatedSeconds")->asNumber() < *json.find("simulatedSeconds")->asNumber());
    QVERIFY(*coarse.find("cpuSeconds")->asNumber() < *json.find("cpuSeconds")->asNumber());
    QVERIFY(*json.find("atRest")->asBool());
}

void tst_SewCommand::aCoarserMeshIsNoRefinement() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--spacing", "100", "--refine"});
    QCOMPARE(finished.status, 1);
    QVERIFY2(finished.err.contains("no coarser than --spacing 100"), qPrintable(finished.err));
    QVERIFY(finished.err.contains("two-squares.toile"));
}

void tst_SewCommand::selfContactCanBeAskedForWhereTheDocumentDoesNot() {
    const auto hasStage = [&](const QStringList& options) {
        const Finished finished =
            run(QStringList{"sew", sample("two-squares.toile"), "--report", in("sew.json")} + options);
        if (finished.status != 0) qFatal("%s", qPrintable(finished.err));
        const Json json = report();
        return std::ranges::any_of(*json.find("stages")->asArray(),
                                   [](const Json& stage) { return *stage.find("name")->asString() == "self-contact"; });
    };
    QVERIFY(!hasStage({}));
    QVERIFY(hasStage({"--self-contact"}));
}

void tst_SewCommand::quietSaysNothing() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--quiet"});
    QCOMPARE(finished.status, 0);
    QVERIFY2(finished.err.isEmpty(), qPrintable(finished.err));
}

void tst_SewCommand::aSeamHeldOpenIsAGoalMissed() {
    const QString document = squaresWith(box(0.05, 2.0));
    const Finished finished =
        run({"sew", document, "--limit", "6", "--out", in("drape.glb"), "--report", in("sew.json"), "--quiet"});
    QCOMPARE(finished.status, 3);
    QVERIFY(finished.out.contains("0 of 1 seams closed"));
    QVERIFY(finished.err.contains("seam \"middle\": The seam is not closed; its gap is 5"));
    const Json json = report();
    const Json& seam = json.find("seams")->asArray()->front();
    QCOMPARE(*seam.find("closed")->asBool(), false);
    QVERIFY(*seam.find("maximumGap")->asNumber() >= 0.050);
    QVERIFY(!contentOf(in("drape.glb")).isEmpty()); // what there is can still be looked at
}

void tst_SewCommand::aLimitThatIsTooShortIsAGoalMissed() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--limit", "1.5", "--report", in("sew.json")});
    QCOMPARE(finished.status, 3);
    QCOMPARE(*report().find("ending")->asString(), std::string("limit reached"));
    QCOMPARE(*report().find("atRest")->asBool(), false);
}

void tst_SewCommand::aStartInTheBodyIsWarnedOfRefusedOrArranged() {
    const QString document = squaresWith(box(1.0, 0.1)); // the squares hang in its middle, in the plane z = 0
    const Finished warned = run({"sew", document, "--seconds", "0.02", "--quiet"});
    QCOMPARE(warned.status, 3);
    QVERIFY2(warned.err.contains("start: The garment starts 50.0 mm inside the body"), qPrintable(warned.err));
    const Finished refused = run({"sew", document, "--seconds", "0.02", "--strict", "--out", in("drape.glb")});
    QCOMPARE(refused.status, 1);
    QVERIFY(refused.err.contains("leave out --strict"));
    QVERIFY(!QFile::exists(in("drape.glb")));
    const Finished arranged = run({"sew", document, "--seconds", "0.02", "--strict", "--arrange", "auto", "--quiet"});
    QCOMPARE(arranged.status, 3); // in so short a time no seam closes
    QVERIFY(!arranged.err.contains("inside the body"));
}

void tst_SewCommand::everyMethodDrapesWhatXpbdHasSewn_data() {
    QTest::addColumn<QString>("method");
    for (const char* method : {"xpbd", "trbdf2", "static", "backward-euler", "bdf2", "midpoint", "sdirk4", "rk4",
                               "symplectic-euler", "subcycled-euler", "baraff-witkin"})
        QTest::newRow(method) << method;
}

void tst_SewCommand::everyMethodDrapesWhatXpbdHasSewn() {
    QFETCH(QString, method);
    QStringList arguments{
        "sew",         sample("two-squares.toile"), "--spacing", "50", "--method", method, "--quiet", "--report",
        in("sew.json")};
    if (method != "static")
        arguments << "--seconds"
                  << "0.8";
    const Finished finished = run(arguments);
    QVERIFY2(finished.status == 0 || finished.status == 3, qPrintable(finished.err));
    const Json json = report();
    QCOMPARE(QString::fromStdString(*json.find("method")->asString()), method);
    const auto& phases = *json.find("phases")->asArray();
    QCOMPARE(*phases.front().find("name")->asString(), std::string("sewing"));
    QCOMPARE(*phases.front().find("method")->asString(), std::string("xpbd"));
    if (method == "static") return; // whatever it needs to settle
    QVERIFY(phases.size() >= 2);
    QCOMPARE(QString::fromStdString(*phases.back().find("method")->asString()), method);
    QVERIFY(*phases.back().find("parts")->asNumber() >= 1);
}

void tst_SewCommand::thePaperGoesItsOwnWayFromEndToEnd() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--spacing", "50", "--paper", "--seconds", "1",
                                   "--quiet", "--report", in("sew.json")});
    QVERIFY2(finished.status == 0, qPrintable(finished.err + finished.out));
    const Json json = report();
    QCOMPARE(*json.find("method")->asString(), std::string("paper"));
    for (const Json& phase : *json.find("phases")->asArray())
        QCOMPARE(*phase.find("method")->asString(), std::string("subcycled-euler"));
    QVERIFY(*json.find("springs")->find("flexion")->asNumber() > 0);
    QCOMPARE(*json.find("springs")->find("bending")->asNumber(), 0.0);
    const Finished both = run({"sew", sample("two-squares.toile"), "--paper", "--method", "trbdf2"});
    QCOMPARE(both.status, 2);
    QVERIFY(both.err.contains("--method"));
}

void tst_SewCommand::staticsKnowsNoTime() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--method", "static", "--seconds", "1"});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains("--seconds"));
}

void tst_SewCommand::theReportSaysHowManyThreadsThereWere() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--threads", "3", "--quiet",
                                   "--report", in("sew.json")});
    QCOMPARE(finished.status, 3); // no garment is sewn in a tenth of a second
    QCOMPARE(*report().find("threads")->asNumber(), 3.0);
}

void tst_SewCommand::aMissingFolderIsSaidAndNothingIsWritten() {
    const Finished finished =
        run({"sew", sample("two-squares.toile"), "--out", in("drape.glb"), "--report", in("none/sew.json")});
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1);
    QVERIFY(finished.err.contains("There is no folder"));
    QVERIFY(QDir(folder_->path()).isEmpty());
}

void tst_SewCommand::noResultTakesThePlaceOfAnInputOrOfAnother_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("a report over the document") << QStringList{"--report", "squares.toile"};
    QTest::newRow("a report over the document, by another way") << QStringList{"--report", "poses/../squares.toile"};
    QTest::newRow("a report over the document, by a link") << QStringList{"--report", "link.toile"};
    QTest::newRow("a checkpoint over the document") << QStringList{"--checkpoint", "squares.toile"};
    QTest::newRow("a drape over the document's avatar") << QStringList{"--out", "body.glb"};
    QTest::newRow("a drape over another avatar") << QStringList{"--avatar", "poses/a.glb", "--out", "poses/a.glb"};
    QTest::newRow("a drape over a pose") << QStringList{"--motion", "poses", "--out", "poses/a.glb"};
    QTest::newRow("frames among the poses") << QStringList{"--motion", "poses", "--frames", "poses"};
    QTest::newRow("a report over what it goes on from") << QStringList{"--resume", "point", "--report", "point"};
    QTest::newRow("a drape and its report") << QStringList{"--out", "same.obj", "--report", "./same.obj"};
    QTest::newRow("a checkpoint and a report") << QStringList{"--checkpoint", "same", "--report", "same"};
    QTest::newRow("two pictures") << QStringList{"--picture", "same.png,same.png"};
}

void tst_SewCommand::noResultTakesThePlaceOfAnInputOrOfAnother() {
    QFETCH(QStringList, options);
    const QString document = squaresWith(box(0.05, 0.05));
    QVERIFY(QDir().mkpath(in("poses")));
    QVERIFY(QFile::copy(in("body.glb"), in("poses/a.glb")));
    QVERIFY(QFile::link(document, in("link.toile")));
    QVERIFY(QFile::copy(document, in("point")));
    const QString workingFolder = QDir::currentPath();
    QVERIFY(QDir::setCurrent(folder_->path()));
    const QByteArray before = contentOf(document), body = contentOf(in("body.glb"));
    const Finished finished = run(QStringList{"sew", document, "--seconds", "0.02"} + options);
    QVERIFY(QDir::setCurrent(workingFolder));
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1); // no progress: nothing was done
    QVERIFY2(finished.err.contains("name another file"), qPrintable(finished.err));
    QCOMPARE(contentOf(document), before);
    QCOMPARE(contentOf(in("body.glb")), body);
    QCOMPARE(contentOf(in("poses/a.glb")), body);
    QCOMPARE(contentOf(in("point")), before);
    QVERIFY(!QFile::exists(in("same")) && !QFile::exists(in("same.obj")) && !QFile::exists(in("same.png")));
}

void tst_SewCommand::whatCannotBeWrittenIsSaidBeforeTheRun_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("a drape where a folder is") << QStringList{"--out", "folder.glb"};
    QTest::newRow("a report where a folder is") << QStringList{"--report", "folder.glb"};
    QTest::newRow("a picture where a folder is") << QStringList{"--picture", "folder.png"};
    QTest::newRow("a checkpoint where a folder is") << QStringList{"--checkpoint", "folder.glb"};
    QTest::newRow("a point cache where a folder is") << QStringList{"--frames", "folder.pc2"};
    QTest::newRow("frames where a file is") << QStringList{"--frames", "file"};
    QTest::newRow("frames among others") << QStringList{"--frames", "kept"};
    QTest::newRow("a folder that takes no file") << QStringList{"--out", "/proc/drape.glb"};
    QTest::newRow("a folder that takes no folder") << QStringList{"--frames", "/proc/frames"};
}

void tst_SewCommand::whatCannotBeWrittenIsSaidBeforeTheRun() {
    QFETCH(QStringList, options);
    for (const char* folder : {"folder.glb", "folder.png", "folder.pc2", "kept"}) QVERIFY(QDir().mkpath(in(folder)));
    for (const char* file : {"file", "kept/frame-00000.obj"})
        QVERIFY(QFile::copy(sample("two-squares.toile"), in(file)));
    if (!QDir::isAbsolutePath(options.last())) options.last() = in(qPrintable(options.last()));
    const Finished finished =
        run(QStringList{"sew", sample("two-squares.toile"), "--spacing", "10", "--refine", "--limit", "0.1"} + options);
    QCOMPARE(finished.status, 1);
    QCOMPARE(finished.errorLines().size(), 1); // no progress, no seam that stayed open
    QVERIFY2(finished.err.startsWith(options.last() + ": "), qPrintable(finished.err));
    QCOMPARE(QDir(folder_->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(), 5);
}

void tst_SewCommand::namesMayEndInCapitals() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--frames", in("CACHE.PC2"),
                                   "--out", in("DRAPE.OBJ"), "--picture", in("FRONT.PNG")});
    QCOMPARE(finished.status, 3); // not sewn yet
    QVERIFY(contentOf(in("CACHE.PC2")).startsWith("POINTCACHE2"));
    QVERIFY(contentOf(in("DRAPE.OBJ")).contains("\nv "));
    QVERIFY(contentOf(in("FRONT.PNG")).contains("PNG"));
}

void tst_SewCommand::aCheckpointMayTakeThePlaceOfTheOneItGoesOnFrom() {
    const QStringList sew{"sew", sample("two-squares.toile"), "--seconds", "0.1", "--checkpoint", in("point")};
    QCOMPARE(run(sew).status, 3); // not sewn yet
    const QByteArray first = contentOf(in("point"));
    QCOMPARE(run(sew + QStringList{"--resume", in("point")}).status, 3);
    QVERIFY(!first.isEmpty() && contentOf(in("point")) != first);
}

void tst_SewCommand::aBrokenDocumentIsRefused() {
    const Finished finished = run({"sew", sample("broken/unknown-piece-in-seam.toile"), "--out", in("drape.glb")});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains("There is no piece \"sleeve\"."));
    QVERIFY(QDir(folder_->path()).isEmpty());
}

void tst_SewCommand::anInterruptLeavesNothingBehind_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("Ctrl+C") << SIGINT;
    QTest::newRow("told to end") << SIGTERM;
    QTest::newRow("the terminal is closed") << SIGHUP;
}

void tst_SewCommand::aRunThatIsToldToEndKeepsItsCheckpoint() {
    QFETCH(int, signal);
    QProcess process;
    process.setReadChannel(QProcess::StandardError);
    process.start(program(), {"sew", sample("blouse.toile"), "--spacing", "10", "--checkpoint", in("point")});
    QVERIFY(process.waitForReadyRead(60000));
    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(contentOf(in("point")).contains("toile-checkpoint"));
}

void tst_SewCommand::anInterruptLeavesNothingBehind() {
    QFETCH(int, signal);
    QProcess process; // a garment that takes minutes
    process.setReadChannel(QProcess::StandardError);
    process.start(program(), {"sew", sample("blouse.toile"), "--spacing", "10", "--out", in("drape.glb"), "--report",
                              in("sew.json"), "--frames", in("cache.pc2")});
    QVERIFY(process.waitForReadyRead(60000)); // its first word of progress
    const auto files = [this] {               // what grows has a name that is hidden
        return QDir(folder_->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    };
    QVERIFY(files().join(' ').contains(".cache.pc2."));
    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QVERIFY(process.exitCode() != 0);
    QVERIFY(process.readAllStandardError().contains("stopped"));
    QCOMPARE(files(), QStringList());
}

void tst_SewCommand::aStoppedRunGoesOnFromItsCheckpoint() {
    const QString squares = sample("two-squares.toile"), point = in("squares.checkpoint");
    const auto hashAfter = [&](const QStringList& options) {
        const Finished finished = run(QStringList{"sew", squares, "--report", in("sew.json")} + options);
        return finished.status == 0 ? *report().find("resultHash")->asString() : finished.err.toStdString();
    };
    (void)run({"sew", squares, "--seconds", "0.3", "--checkpoint", point}); // its seam is not closed yet
    const std::string once = hashAfter({"--resume", point, "--seconds", "1"});
    QCOMPARE(once.size(), std::size_t{64}); // the seam is closed now
    QCOMPARE(hashAfter({"--resume", point, "--seconds", "1"}), once);
    QVERIFY(hashAfter({"--resume", point, "--seconds", "1", "--spacing", "10"}).find("another scene") !=
            std::string::npos);
    QVERIFY(hashAfter({"--resume", in("none")}).find("none") != std::string::npos);
}

void tst_SewCommand::wrongUsage_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("an unknown option") << QStringList{"--faster"};
    QTest::newRow("an unknown method") << QStringList{"--method", "magic"};
    QTest::newRow("an unknown arrangement") << QStringList{"--arrange", "tidy"};
    QTest::newRow("so long, and until rest") << QStringList{"--seconds", "3", "--until-rest"};
    QTest::newRow("the paper has no self-contact") << QStringList{"--paper", "--self-contact"};
    QTest::newRow("refined to nothing") << QStringList{"--refine"};
    QTest::newRow("refined in no time") << QStringList{"--refine", "--spacing", "20", "--seconds", "3"};
    QTest::newRow("no substep") << QStringList{"--substeps", "0"};
    QTest::newRow("no thread") << QStringList{"--threads", "0"};
    QTest::newRow("a step of nothing") << QStringList{"--step", "0"};
    for (const char* option : {"--seconds", "--limit", "--hold", "--spacing", "--step", "--lift-arms"})
        for (const char* value : {"nan", "-nan", "inf"})
            QTest::addRow("%s %s", option, value) << QStringList{option, value};
    for (const char* option : {"--avatar", "--out", "--report", "--frames", "--checkpoint", "--resume", "--picture"})
        QTest::addRow("%s of nothing", option) << QStringList{option, ""};
    QTest::newRow("--lift-time nan") << QStringList{"--lift-arms", "20", "--lift-time", "nan"};
    QTest::newRow("--motion-step nan") << QStringList{"--motion", "poses", "--motion-step", "nan"};
}

void tst_SewCommand::wrongUsage() {
    QFETCH(QStringList, options);
    const Finished finished = run(QStringList{"sew", sample("two-squares.toile")} + options);
    QCOMPARE(finished.status, 2);
    QVERIFY(!finished.err.isEmpty());
    if (options.last() == "nan" || options.last().isEmpty())
        QVERIFY2(finished.err.contains(options[options.size() - 2]), qPrintable(finished.err));
}

QTEST_GUILESS_MAIN(tst_SewCommand)
#include "tst_SewCommand.moc"
