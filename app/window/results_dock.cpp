#include "app/window/results_dock.h"

#include <QFormLayout>
#include <QLabel>

namespace noonmark {

ResultsDock::ResultsDock(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)), note_(new QLabel) {
    note_->setWordWrap(true);
    form_->addRow(note_);
    show({});
}

void ResultsDock::show(const std::vector<ResultRow>& rows) {
    while (form_->rowCount() > 1) form_->removeRow(1);
    filled_ = !rows.empty();
    note_->setText(tr("No study yet."));
    note_->setVisible(!filled_);
    for (const ResultRow& row : rows) {
        auto* value = new QLabel(row.value);
        value->setWordWrap(true);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setToolTip(row.meaning);
        form_->addRow(row.name, value);
        form_->labelForField(value)->setToolTip(row.meaning);
    }
}

void ResultsDock::setOutdated(bool outdated) {
    if (!filled_) return;
    note_->setText(tr("The settings have changed since: run again."));
    note_->setVisible(outdated);
}

}  // namespace noonmark
