#include "app/gui/frame/actions/result_actions.h"

#include <QClipboard>
#include <QDir>
#include <QGuiApplication>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/results/result_display.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_presets.h"
#include "app/gui/view/time/time_strip.h"
#include "app/questions/review_question.h"
#include "app/report/sheets/study_text.h"
#include "core/study/contributions/place_contributions.h"

namespace noonmark {

namespace {

QString text(const std::string& name) { return QString::fromStdString(name); }

Result<void> save(const QImage& image, const QString& file) {
    if (image.save(file)) return {};
    return failure(QT_TRANSLATE_NOOP("Error", "The picture could not be written"), file.toStdString(),
                   QT_TRANSLATE_NOOP("Error", "Choose another folder"));
}

}  // namespace

ResultActions::ResultActions(Workbench& workbench, const ModeSwitch& mode, const ResultDisplay& display,
                             ViewPanel& panel, ProjectDock& tree, QWidget& window)
    : workbench_(workbench),
      mode_(mode),
      display_(display),
      panel_(panel),
      window_(window),
      savePicture_(makeAction(this, tr("Save &picture..."), QKeySequence(tr("Ctrl+P")),
                              tr("The view with its legend, as a PNG file"), "picture")),
      export_(makeAction(this, tr("&Export..."), QKeySequence(tr("Ctrl+E")),
                         tr("The displayed result, all scenarios or the review, as PDF, picture, GeoTIFF, "
                            "tables and JSON"),
                         "export")),
      saveResult_(makeAction(this, tr("&Save result"), {},
                             tr("Stores the displayed map and figures in the project"))) {
    connect(savePicture_, &QAction::triggered, this, [this] { savePicture(askForPicture(&window_)); });
    export_->setObjectName(QStringLiteral("exportResults"));
    connect(export_, &QAction::triggered, this, &ResultActions::askForExport);
    connect(saveResult_, &QAction::triggered, this, &ResultActions::saveInProject);
    connect(&tree, &ProjectDock::saveResultRequested, this, &ResultActions::saveInProject);
    connect(&tree, &ProjectDock::resultChosen, &workbench_, &Workbench::showSaved);
    connect(&display_, &ResultDisplay::updated, this, &ResultActions::nameExport);
    connect(&workbench_, &Workbench::projectOpened, this, [this] {  // its files go to a folder of their own
        lastFolder_.clear();
        if (dialog_) dialog_->close();
    });
}

void ResultActions::savePicture(const QString& file) {
    if (file.isEmpty()) return;
    if (const auto may = checkOutput(file.toStdString(), OutputKind::picture, workbench_.exportRules()); !may)
        return panel_.messages().showError(may.error());
    takePicture([this, file](const QImage& image) {
        if (const auto saved = save(image, file); !saved) return panel_.messages().showError(saved.error());
        panel_.messages().showNote(tr("Picture saved as %1").arg(file));
    });
}

void ResultActions::copyPicture() {
    takePicture([this](const QImage& image) {
        QGuiApplication::clipboard()->setImage(image);
        panel_.messages().showNote(tr("Picture copied"));
    });
}

void ResultActions::takePicture(std::function<void(const QImage&)> done) {
    const auto [title, when] = pictureTitle();
    panel_.takePicture(title, when, std::move(done));
}

// What is shown, and when.
std::pair<QString, QString> ResultActions::pictureTitle() const {
    if (const PlaceView* verdicts = panel_.results().shownVerdicts())
        return {tr("%1: %2").arg(workbench_.projectName(), verdicts->note), {}};
    const ProjectSession& session = workbench_.session();
    QString title = tr("%1: %2").arg(workbench_.projectName(), scenarioName(session.scenario()));
    if (!session.baseline().empty())
        title = tr("%1 compared with %2").arg(title, scenarioName(session.baseline()));
    const Period& period = mode_.mode() == ViewMode::exploration || !display_.anyShown()
                               ? workbench_.document().settings().period
                               : display_.settings().period;
    const ShownTime& look = panel_.time().look();
    return {title, look.span == ShownSpan::moment ? describe(look) : describeWhen(period)};
}

std::vector<ExportDialog::Subject> ResultActions::exportSubjects() const {
    using Subject = ExportChoice::Subject;
    std::vector<ExportDialog::Subject> subjects;
    if (workbench_.answer()) subjects.push_back({Subject::shown, shownText()});
    if (const auto place = workbench_.placeShown())
        subjects.push_back(
            {Subject::place, tr("Contributions to the shadow on %1").arg(placeName(place->place.name))});
    if (const auto measured = workbench_.measuredScenarios(); measured.size() > 1)
        subjects.push_back(
            {Subject::scenarios, tr("All %1 scenario(s) measured", "", pluralNumber(measured.size()))
                                     .arg(formatCount(measured.size()))});
    if (workbench_.hasScenarioAnswers())
        subjects.push_back({Subject::table, tr("Table of scenarios: scores, verdicts, sun of places")});
    if (workbench_.city()) subjects.push_back({Subject::view, tr("Picture of the view")});
    return subjects;
}

namespace {

// A study of the city as its files have it.
bool isStudyOfFiles(Workbench& workbench) {
    const auto hasEdits = [](const Scenario& scenario) { return !scenario.edits.empty(); };
    return workbench.answerAs<Study>() &&
           std::ranges::none_of(workbench.session().project().scenarios, hasEdits);
}

}  // namespace

// Without a city there is nothing to ask for: the workbench refuses and says why.
void ResultActions::askForExport() {
    const auto subjects = exportSubjects();
    if (subjects.empty()) return workbench_.exportShown({}, {});
    if (!dialog_) makeExportDialog();
    dialog_->offer(subjects);
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

void ResultActions::askForContributions() {
    askForExport();
    if (dialog_) dialog_->choose(ExportChoice::Subject::place);
}

void ResultActions::makeExportDialog() {
    dialog_ = new ExportDialog(
        last_, lastFolder_,
        {[this](const ExportChoice& choice) { return workbench_.filesOf(drawn(choice)); },
         [this](const ExportChoice& choice) { return workbench_.sheetsOf(drawn(choice)); },
         [this](const ExportChoice& choice) { return workbench_.hasSheets(choice); },
         [this](const ExportChoice& choice) {
             return choice.subject == ExportChoice::Subject::shown && workbench_.answerAs<ReviewAnswer>();
         },
         [this](const ExportChoice& choice) {
             return choice.subject == ExportChoice::Subject::shown && isStudyOfFiles(workbench_);
         }},
        workbench_.session(), &window_);
    connect(dialog_, &ExportDialog::chosen, this, &ResultActions::exportTo);
    connect(dialog_, &ExportDialog::setupChosen, this, &ResultActions::setupChosen);
    connect(dialog_, &ExportDialog::saveRequested, this, &ResultActions::saveRequested);
    dialog_->followWriting(workbench_.writing());
    connect(&workbench_, &Workbench::exported, dialog_, &ExportDialog::showWritten);
    connect(&workbench_, &Workbench::failed, dialog_, &ExportDialog::showError);
    connect(&display_, &ResultDisplay::updated, dialog_, [this] { offerSubjects(); });
}

// What is shown may have changed since the dialog was opened.
void ResultActions::offerSubjects() {
    const auto subjects = exportSubjects();
    if (subjects.empty()) return dialog_->close(), void();
    dialog_->offer(subjects);
}

/// With the colours that the view has.
ExportChoice ResultActions::drawn(ExportChoice choice) const {
    choice.scale = panel_.legend().changeScale();
    choice.legend = panel_.legend().choice();
    if (const PlaceView* places = panel_.results().places()) {
        choice.legend.show = places->show;
        choice.legend.trees = places->trees;
        choice.thresholdHours = places->thresholdHours;
    }
    return choice;
}

void ResultActions::exportTo(const ExportChoice& chosen, const QString& folder) {
    const ExportChoice choice = drawn(chosen);
    last_ = choice;
    lastFolder_ = folder;
    if (!mayReplace(&window_, folder, workbench_.listExistingFiles(folder.toStdString(), choice))) return;
    choice.subject == ExportChoice::Subject::view ? exportView(choice, folder)
                                                  : workbench_.exportShown(folder.toStdString(), choice);
}

void ResultActions::exportView(const ExportChoice& choice, const QString& folder) {
    const QString file = QDir(folder).filePath(workbench_.filesOf(choice).front());
    if (const auto may = checkOutput(file.toStdString(), OutputKind::picture, workbench_.exportRules()); !may)
        return dialog_->showError(may.error());
    const auto [title, when] = pictureTitle();
    panel_.takePicture({.frame = panel_.pictureFrame(title, when),
                        .size = {choice.pictureWidth, choice.pictureHeight},
                        .framed = choice.framed},
                       [this, file, folder](const QImage& image) {
                           QDir().mkpath(folder);
                           const auto saved = save(image, file);
                           if (!dialog_) return;
                           saved ? dialog_->showWritten(folder) : dialog_->showError(saved.error());
                       });
}

QString ResultActions::shownText() const {
    const auto answer = workbench_.answer();
    return answer ? titleOf(*answer) : QString();
}

// The menu item names what is displayed.
void ResultActions::nameExport() {
    QString words = shownText();
    words.replace(QLatin1Char('&'), QStringLiteral("&&"));  // an ampersand in a name is not a mnemonic
    export_->setText(words.isEmpty() ? tr("&Export...") : tr("&Export (%1)...").arg(words));
}

void ResultActions::saveInProject() {
    const auto answer = workbench_.answer();
    workbench_.saveAnswer(answer ? text(nameToSave(*answer)) : QString());
}

}  // namespace noonmark
