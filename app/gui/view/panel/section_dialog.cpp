#include "app/gui/view/panel/section_dialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/widgets/length_field.h"
#include "app/gui/view/panel/section_tool.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

namespace {

constexpr double farthestFieldM = 200000;

}  // namespace

SectionDialog::SectionDialog(ViewPanel& panel, QWidget* parent)
    : QDialog(parent, Qt::Tool), panel_(panel), tool_(panel.section()) {
    setObjectName(QStringLiteral("sectionDialog"));
    setWindowTitle(tr("Section box"));
    new QVBoxLayout(this);
    addFields();
    addButtons();
    connect(&tool_, &SectionTool::changed, this, &SectionDialog::showBox);
    showBox();
}

void SectionDialog::addFields() {
    const std::array names{tr("West"), tr("East"), tr("South"), tr("North"), tr("Bottom"), tr("Top")};
    auto* form = new QFormLayout;
    for (std::size_t side = 0; side < fields_.size(); ++side) {
        LengthField* field = lengthField(-farthestFieldM, farthestFieldM, 1, 1);
        field->setObjectName(QStringLiteral("section%1").arg(side));
        field->setToolTip(side < 4 ? tr("From the origin of the project, to the east and to the north")
                                   : tr("Height above the origin of the project"));
        connect(field, &QDoubleSpinBox::valueChanged, this, [this, side] { takeField(side); });
        form->addRow(names[side], field);
        fields_[side] = field;
    }
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

void SectionDialog::addButtons() {
    auto* row = new QHBoxLayout;
    const auto add = [row](const QString& text, const QString& tip, const char* name) {
        auto* button = new QPushButton(text);
        button->setToolTip(tip);
        button->setObjectName(QString::fromLatin1(name));
        button->setAutoDefault(false);
        row->addWidget(button);
        return button;
    };
    QPushButton* view =
        add(tr("What the view shows"), tr("The box around the ground in view"), "sectionView");
    QPushButton* city = add(tr("Reset"), tr("The box around the whole city"), "sectionReset");
    QPushButton* off = add(tr("Remove"), tr("Shows everything again"), "sectionRemove");
    connect(view, &QPushButton::clicked, this, &SectionDialog::takeView);
    connect(city, &QPushButton::clicked, &tool_, &SectionTool::setAroundCity);
    connect(off, &QPushButton::clicked, this, &SectionDialog::removed);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void SectionDialog::showEvent(QShowEvent* event) {
    tool_.showHandles(true);
    QDialog::showEvent(event);
}

void SectionDialog::hideEvent(QHideEvent* event) {
    tool_.showHandles(false);
    QDialog::hideEvent(event);
}

void SectionDialog::showBox() {
    if (!tool_.box()) return;
    for (std::size_t side = 0; side < fields_.size(); ++side) {
        const QSignalBlocker quiet(fields_[side]);
        fields_[side]->setValue(positionOf(*tool_.box(), sectionSides[side]));
    }
}

void SectionDialog::takeField(std::size_t side) {
    if (tool_.box()) tool_.set(moveSide(*tool_.box(), sectionSides[side], fields_[side]->value()));
}

void SectionDialog::takeView() {
    const Box2 ground = bounds(panel_.visibleGround());
    if (!ground.empty()) tool_.setAround(ground);
}

}  // namespace noonmark
