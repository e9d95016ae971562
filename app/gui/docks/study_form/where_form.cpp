#include "app/gui/docks/study_form/where_form.h"

#include <QComboBox>
#include <QCompleter>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "core/receivers/place_names.h"

namespace noonmark {

WhereForm::WhereForm(QWidget* parent) : QWidget(parent), names_(new QComboBox), region_(new QLabel) {
    region_->setWordWrap(true);
    region_->setMinimumHeight(2 * fontMetrics().lineSpacing() + 2);  // name and size, also in a low window
    makeList();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(names_);
    column->addWidget(makeButtons());
    column->addWidget(region_);
}

// Editable, so that one of hundreds of places is found by a part of its name.
void WhereForm::makeList() {
    names_->setObjectName(QStringLiteral("regionList"));
    names_->setEditable(true);
    names_->setInsertPolicy(QComboBox::NoInsert);
    names_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    names_->setMinimumContentsLength(8);
    names_->completer()->setFilterMode(Qt::MatchContains);
    names_->completer()->setCompletionMode(QCompleter::PopupCompletion);
    names_->lineEdit()->setPlaceholderText(tr("Place or region by name"));
    names_->setToolTip(tr("A place or a region of the project. Type a part of its name."));
    const auto emitName = [this] {
        if (!names_->currentText().isEmpty()) Q_EMIT named(names_->currentText());
    };
    connect(names_, &QComboBox::activated, this, emitName);
    connect(names_->lineEdit(), &QLineEdit::returnPressed, this, emitName);
}

QWidget* WhereForm::makeButtons() {
    draw_ = pushButton(tr("Draw"), "draw",
                       tr("Click the corners of a polygon on the ground.\nDouble click, Enter or right click "
                          "finishes, Backspace removes the last corner, Esc cancels."));
    draw_->setCheckable(true);
    auto* view = pushButton(tr("What I see"), "viewRegion", tr("The ground visible in the view"));
    auto* city = pushButton(tr("Whole city"), "wholeCity", tr("The bounding box of all buildings"));
    surroundings_ = pushButton(tr("Around building"), "surroundings",
                               tr("The selected building's surroundings, as far as four times its height.\n"
                                  "Click a building first."));
    surroundings_->setEnabled(false);
    auto* buttons = new QWidget;
    auto* grid = new QGridLayout(buttons);
    grid->setContentsMargins(0, 0, 0, 0);
    int cell = 0;
    for (QPushButton* button : {draw_, view, surroundings_, city}) {
        grid->addWidget(button, cell / 2, cell % 2);
        ++cell;
    }
    connect(draw_, &QPushButton::toggled, this, &WhereForm::drawRequested);
    connect(view, &QPushButton::clicked, this, &WhereForm::viewRequested);
    connect(city, &QPushButton::clicked, this, &WhereForm::wholeCityRequested);
    connect(surroundings_, &QPushButton::clicked, this, &WhereForm::surroundingsRequested);
    return buttons;
}

void WhereForm::setNames(const QStringList& names) {
    QStringList before;
    for (int i = 0; i < names_->count(); ++i) before << names_->itemText(i);
    if (before != names) {
        const QSignalBlocker quiet(names_);
        names_->clear();
        names_->addItems(names);
    }
    showName();
}

void WhereForm::show(const StudySettings& settings) {
    name_ = QString::fromStdString(settings.region.name);
    region_->setText(describeRegion(settings.region, settings.receivers.cellM));
    showName();
}

void WhereForm::showName() {
    const QSignalBlocker quiet(names_);
    const int found = names_->findText(name_);
    names_->setCurrentIndex(found);
    if (found < 0) names_->clearEditText();
}

void WhereForm::setDrawing(bool drawing) {
    const QSignalBlocker quiet(draw_);
    draw_->setChecked(drawing);
}

void WhereForm::setBuilding(bool selected) { surroundings_->setEnabled(selected); }

}  // namespace noonmark
