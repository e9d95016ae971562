#include "app/window/actions/result_actions.h"

#include "app/report/sheets/period_words.h"
#include "app/window/actions/make_action.h"
#include "app/window/frame/workbench.h"
#include "app/window/project/project_dock.h"
#include "app/window/results/result_display.h"
#include "app/window/time/time_strip.h"
#include "app/window/view/mode_switch.h"
#include "app/window/view/view_panel.h"
#include "app/window/widgets/file_dialogs.h"

namespace noonmark {

namespace {

QString text(const std::string& name) { return QString::fromStdString(name); }

}  // namespace

ResultActions::ResultActions(Workbench& workbench, const ModeSwitch& mode, const ResultDisplay& display,
                             ViewPanel& panel, ProjectDock& tree, QWidget& window)
    : workbench_(workbench),
      mode_(mode),
      display_(display),
      panel_(panel),
      window_(window),
      savePicture_(makeAction(this, tr("Save &picture..."), QKeySequence(tr("Ctrl+P")),
                              tr("The view with its legend, as a PNG file"))),
      export_(makeAction(this, tr("&Export study..."), QKeySequence(tr("Ctrl+E")),
                         tr("The displayed result as GeoTIFF, map, PDF page, table and JSON, as the command "
                            "line writes them"))),
      saveResult_(makeAction(this, tr("&Save result"), {},
                             tr("Stores the displayed map and figures in the project"))) {
    connect(savePicture_, &QAction::triggered, this, [this] { savePicture(askForPicture(&window_)); });
    connect(export_, &QAction::triggered, this, &ResultActions::exportShown);
    connect(saveResult_, &QAction::triggered, this, &ResultActions::saveInProject);
    connect(&tree, &ProjectDock::keepResultRequested, this, &ResultActions::saveInProject);
    connect(&tree, &ProjectDock::resultChosen, &workbench_, &Workbench::showSaved);
    connect(&display_, &ResultDisplay::updated, this, &ResultActions::nameExport);
}

void ResultActions::savePicture(const QString& file) {
    if (file.isEmpty()) return;
    if (const auto may = checkOutput(file.toStdString(), OutputKind::picture, workbench_.exportRules()); !may)
        return panel_.messages().showError(may.error());
    const ProjectSession& session = workbench_.session();
    QString title = tr("%1: %2").arg(workbench_.projectName(), text(session.scenario()));
    if (!session.baseline().empty()) title = tr("%1 compared with %2").arg(title, text(session.baseline()));
    const Period& period = mode_.mode() == ViewMode::exploration || !display_.anyShown()
                               ? workbench_.document().settings().period
                               : display_.settings().period;
    const TimeLook& look = panel_.time().look();
    const QString when = look.span == LookSpan::moment ? describe(look) : describePeriod(period);
    panel_.takePicture(title, when, [this, file](const QImage& image) {
        if (image.save(file)) return panel_.messages().showNote(tr("Picture saved as %1").arg(file));
        panel_.messages().showError(
            {"The picture could not be written", file.toStdString(), "Choose another folder"});
    });
}

// Without a result to export there is nothing to ask for: the workbench refuses and says why.
void ResultActions::exportShown() {
    const bool something = workbench_.shown() != Workbench::Shown::nothing &&
                           workbench_.shown() != Workbench::Shown::savedResult;
    const QString folder =
        something ? askForFolder(&window_, tr("%1 to folder").arg(exportText())) : QStringLiteral(".");
    if (folder.isEmpty()) return;
    if (mayReplace(&window_, folder, workbench_.filesInTheWay(folder.toStdString())))
        workbench_.exportShown(folder.toStdString(), panel_.legend().changeScale());
}

// The export writes the displayed result; the menu item names it.
QString ResultActions::exportText() const {
    const auto comparison = workbench_.comparison();
    const auto score = workbench_.score();
    switch (workbench_.shown()) {
        case Workbench::Shown::comparison:
            return tr("Export %1 compared with %2").arg(text(comparison->to), text(comparison->from));
        case Workbench::Shown::score:
            return tr("Export the score of %1").arg(text(score->scenario));
        case Workbench::Shown::study:
            return tr("Export study");
        case Workbench::Shown::nothing:
        case Workbench::Shown::savedResult:
            return tr("Export");
    }
    return {};
}

void ResultActions::nameExport() {
    QString words = exportText();
    words.replace(QLatin1Char('&'), QStringLiteral("&&"));  // an ampersand in a name is not a mnemonic
    export_->setText(tr("&%1...").arg(words));
}

void ResultActions::saveInProject() {
    const auto comparison = workbench_.comparison();
    const auto score = workbench_.score();
    const std::string& scenario = workbench_.session().scenario();
    QString name = text(scenario);
    if (score)
        name = tr("Score of %1 with %2").arg(text(scenario), text(score->weights.name));
    else if (comparison)
        name = tr("%1 compared with %2").arg(text(comparison->to), text(comparison->from));
    workbench_.keepAnswer(tr("%1, %2").arg(name, text(formatText(display_.settings().period.start))));
}

}  // namespace noonmark
