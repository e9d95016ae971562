#include "app/gui/frame/actions/copy_actions.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/docks/export/table_text.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/frame/actions/result_actions.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

CopyActions::CopyActions(ResultActions& results, ResultsDock& figures, ViewPanel& panel)
    : results_(results),
      dock_(figures),
      panel_(panel),
      copy_(makeAction(this, tr("&Copy"), QKeySequence::Copy,
                       tr("The table or text last clicked, else the picture of the view"), "copy")),
      figures_(makeAction(this, tr("Copy fi&gures"), {}, tr("The figures of the dock Results, as a table"))),
      picture_(makeAction(this, tr("C&opy picture"), QKeySequence(tr("Ctrl+Shift+C")),
                          tr("The view with title, legend, scale and north"), "picture")) {
    connect(copy_, &QAction::triggered, this, &CopyActions::copy);
    connect(figures_, &QAction::triggered, this, &CopyActions::copyFigures);
    connect(picture_, &QAction::triggered, &results_, &ResultActions::copyPicture);
    dock_.setContextMenuPolicy(Qt::ActionsContextMenu);
    dock_.addAction(figures_);
}

void CopyActions::copy() {
    if (!copyText(QApplication::focusWidget())) results_.copyPicture();
}

bool CopyActions::copyText(QWidget* focus) {
    if (const auto* label = qobject_cast<QLabel*>(focus); label && label->hasSelectedText()) {
        put(label->selectedText(), tr("Text"));
        return true;
    }
    for (QWidget* widget = focus; widget; widget = widget->parentWidget()) {
        if (const auto* view = qobject_cast<QAbstractItemView*>(widget)) {
            const QModelIndexList rows = view->selectionModel()->selectedIndexes();
            const bool several = !rows.isEmpty() && rows.first().row() != rows.last().row();
            put(makeTableText(*view->model(), several ? rows : QModelIndexList()), tr("Table"));
            return true;
        }
        if (widget == &dock_ && !dock_.rows().empty()) {
            copyFigures();
            return true;
        }
    }
    return false;
}

void CopyActions::copyFigures() {
    if (dock_.rows().empty())
        return panel_.messages().showError({"There are no figures to copy", {}, "Press Run first"});
    put(makeTableText(dock_.rows()), tr("Figures"));
}

void CopyActions::copyCommand(const QString& command) { put(command, tr("Command")); }

void CopyActions::put(const QString& text, const QString& what) {
    QApplication::clipboard()->setText(text);
    panel_.messages().showNote(tr("%1 copied").arg(what));
}

}  // namespace noonmark
