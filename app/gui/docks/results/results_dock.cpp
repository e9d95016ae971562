#include "app/gui/docks/results/results_dock.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/push_button.h"
#include "app/gui/docks/results/month_chart.h"

namespace noonmark {

namespace {

QString usualHint() {
    return ResultsDock::tr(
        "No study yet.\nChoose what, when and where in the dock Study, and press Run study (Ctrl+R). The "
        "figures of the study then stand here.");
}

}  // namespace

ResultsDock::ResultsDock(QWidget* parent)
    : QWidget(parent),
      note_(new QLabel),
      back_(pushButton(tr("Show the study again"), "wayBack",
                       tr("Replaces this result by the current study or comparison"))),
      months_(new MonthChart),
      form_(new QFormLayout(this)),
      hint_(usualHint()) {
    note_->setObjectName(QStringLiteral("resultNote"));
    note_->setWordWrap(true);
    // A single layout: in a nested one, wrapped text gets too little height.
    for (QWidget* whole : std::initializer_list<QWidget*>{note_, back_, months_}) form_->addRow(whole);
    fixedRows_ = form_->rowCount();
    connect(back_, &QPushButton::clicked, this, &ResultsDock::studyWanted);
    show({});
}

void ResultsDock::show(const std::vector<ResultRow>& rows, const std::vector<MonthFigures>& months) {
    while (form_->rowCount() > fixedRows_) form_->removeRow(fixedRows_);
    filled_ = !rows.empty();
    rows_ = rows;
    setNote({});
    offerWayBack(false);
    months_->show(months);
    for (const ResultRow& row : rows) {
        auto* value = new QLabel(row.value);
        value->setWordWrap(true);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setToolTip(row.meaning);
        form_->addRow(row.name, value);
        form_->labelForField(value)->setToolTip(row.meaning);
    }
}

void ResultsDock::setNote(const QString& note, bool warns) {
    const bool amber = filled_ && warns;
    const NoteColours colours = warningColours(themeInUse());
    note_->setStyleSheet(amber ? QStringLiteral("background: %1; color: %2; padding: 4px;")
                                     .arg(colours.background.name(), colours.text.name())
                               : QString());
    if (filled_) hint_ = usualHint();
    note_->setText(filled_ ? note : hint_);
    setFaded(amber && !note.isEmpty());
    note_->setVisible(!note_->text().isEmpty());
    fitNote();
}

// Sets the note's height, since the layout gives a wrapped label no height when it returns after a score was
// shown.
void ResultsDock::fitNote() {
    const QMargins margins = form_->contentsMargins();
    const int width = std::max(1, this->width() - margins.left() - margins.right());
    note_->setMinimumHeight(note_->text().isEmpty() ? 0 : note_->heightForWidth(width));
}

void ResultsDock::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitNote();
}

void ResultsDock::setHint(const QString& hint) {
    hint_ = hint.isEmpty() ? usualHint() : hint;
    if (!filled_) setNote({});
}

// Greys out figures that do not belong to what is displayed.
void ResultsDock::setFaded(bool faded) {
    faded_ = faded;
    for (int row = fixedRows_; row < form_->rowCount(); ++row)
        for (const auto role : {QFormLayout::LabelRole, QFormLayout::FieldRole})
            if (QLayoutItem* item = form_->itemAt(row, role))
                item->widget()->setStyleSheet(faded ? QStringLiteral("color: #8b909a;") : QString());
}

void ResultsDock::offerWayBack(bool offered) { back_->setVisible(offered); }

}  // namespace noonmark
