// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/BuildFacts.h"
#include "app/batch/StudyFolder.h"
#include "app/batch/StudyGarment.h"
#include "ui/window/MainWindow.h"
#include "ui/window/Theme.h"
#include "ui/window/Translation.h"
#include "ui/workbench/RealParts.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QLibraryInfo>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTimer>
#include <QTranslator>

#include <fmt/format.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdio>
#include <span>
#include <string_view>

namespace {

using namespace toile;

QString versionText() {
    return QString::fromStdString(batch::versionText("toile")) +
           QStringLiteral("Qt %1\n").arg(QLatin1String(qVersion()));
}

void logQtMessage(QtMsgType type, const QMessageLogContext&, const QString& message) {
    const auto level = type == QtDebugMsg     ? spdlog::level::debug
                       : type == QtInfoMsg    ? spdlog::level::info
                       : type == QtWarningMsg ? spdlog::level::warn
                                              : spdlog::level::critical;
    spdlog::log(level, "{}", message.toStdString());
    if (type != QtDebugMsg) std::fprintf(stderr, "%s\n", qPrintable(message));
}

/// toile.log in the program's data folder, at most three files of a megabyte; without it where it cannot be written.
void startLog(const QString& folder) {
    QDir().mkpath(folder);
    try {
        spdlog::set_default_logger(spdlog::rotating_logger_mt(
            "toile", QDir(folder).filePath(QStringLiteral("toile.log")).toStdString(), 1 << 20, 2));
        spdlog::flush_on(spdlog::level::info);
    } catch (const spdlog::spdlog_ex& problem) {
        std::fprintf(stderr, "toile: no log file: %s\n", problem.what());
        return;
    }
    qInstallMessageHandler(logQtMessage);
    spdlog::info("{}", versionText().simplified().toStdString());
}

/// Where samples lie: installed beside the program, else in the source tree it was built from.
QStringList sampleFolders() {
    const QString installed =
        QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("../share/toile/samples"));
    if (QDir(installed).exists()) return {QDir::cleanPath(installed)};
    return {QStringLiteral(TOILE_SAMPLES)};
}

/// The study as the command line has it; its report says that the window made it.
ui::AccuracyParts accuracyParts() {
    return {[](const auto& name, const auto& scene, const auto& plan, std::stop_token stop, const Progress& progress) {
                return study::studyGarment(name, scene, plan, stop, progress);
            },
            [](std::string command) {
                study::Circumstances circumstances = batch::circumstancesOf(std::move(command));
                const batch::BuildFacts facts = batch::buildFacts();
                circumstances.program = fmt::format("toile {} ({})", facts.version, facts.commit);
                return circumstances;
            },
            [](const auto& folder, const auto& study, const auto& within, const auto& circumstances) {
                return batch::writeGarmentReport(folder, study, within, circumstances).map([](bool) {});
            }};
}

/// Our own texts and Qt's, in the language of the user's system where we have it.
void loadTranslations(QApplication& application) {
    if (auto ours = ui::Translation::of(QLocale())) {
        ours->setParent(&application);
        QApplication::installTranslator(ours.release());
    }
    auto* qts = new QTranslator(&application);
    if (qts->load(QLocale(), QStringLiteral("qtbase"), QStringLiteral("_"),
                  QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QApplication::installTranslator(qts);
}

} // namespace

int main(int argc, char** argv) {
    if (const std::span arguments(argv + 1, argv + argc); // needs no display
        std::ranges::any_of(arguments, [](std::string_view a) { return a == "--version" || a == "-v"; })) {
        std::fputs(qPrintable(versionText()), stdout);
        return 0;
    }
    QSurfaceFormat format; // before the application: every context is of this kind
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("toile"));
    QApplication::setApplicationName(QStringLiteral("toile"));
    QApplication::setApplicationVersion(QStringLiteral(TOILE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("toile"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/toile.svg")));

    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Garment pattern editor and simulation viewer"));
    parser.addHelpOption();
    const QCommandLineOption version({QStringLiteral("v"), QStringLiteral("version")},
                                     QStringLiteral("Print the facts of this build."));
    const QCommandLineOption play(QStringLiteral("play"), QStringLiteral("Start to sew at once."));
    parser.addOptions({version, play});
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("A .toile document or a GarmentCode pattern."),
                                 QStringLiteral("[FILE]"));
    parser.process(application);

    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    startLog(data);
    loadTranslations(application);
    ui::applyTheme(application);
    ui::Workbench workbench(ui::realParts(QDir(data).filePath(QStringLiteral("recovery"))));
    QObject::connect(&workbench, &ui::Workbench::messageChanged, [](const QString& message, bool isProblem) {
        spdlog::log(isProblem ? spdlog::level::warn : spdlog::level::info, "{}", message.toStdString());
    });
    ui::MainWindow window(workbench, {ui::writeDrapeOf, sampleFolders(), versionText().trimmed(), accuracyParts()});
    window.show();
    QTimer::singleShot(0, &window, [&] { // dialogs need the loop running
        const QStringList files = parser.positionalArguments();
        if (!window.files().offerRecovery() && !files.isEmpty()) window.files().openFile(files.front());
        if (parser.isSet(play)) workbench.play();
    });
    return QApplication::exec();
}
