#include "app/gui/frame/preferences/preferences_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QVBoxLayout>

#include "app/gui/base/looks/application_theme.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/sheets/sheet_form.h"
#include "app/gui/frame/help/start_page.h"
#include "app/language/language.h"

namespace noonmark {

namespace {

QComboBox* addList(QFormLayout& form, const QString& label, const char* name, const QString& tip) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->setToolTip(tip);
    form.addRow(label, list);
    return list;
}

void choose(QComboBox& list, int value) { list.setCurrentIndex(list.findData(value)); }
int chosen(const QComboBox& list) { return list.currentData().toInt(); }

}  // namespace

PreferencesDialog::PreferencesDialog(QSettings& settings, QWidget* parent)
    : QDialog(parent), settings_(settings) {
    setWindowTitle(tr("Preferences"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* form = new QFormLayout;
    addLooks(*form);
    addUse(*form);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &PreferencesDialog::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(buttons);
}

void PreferencesDialog::addLooks(QFormLayout& form) {
    language_ =
        addList(form, tr("Language"), "preferredLanguage",
                tr("Of menus, panels and numbers; applies at once. Files and sheets stay English, and so do "
                   "errors and warnings that hold a number or a name"));
    for (const LanguageEntry& entry : languages)
        language_->addItem(entry.ownName ? QString::fromUtf8(entry.ownName) : tr("As the system"),
                           int(entry.language));
    choose(*language_, int(readLanguage(settings_)));
    theme_ = addList(form, tr("Colours"), "preferredColours", tr("Light or dark; applies at once"));
    theme_->addItem(tr("As the system"), int(ThemeChoice::system));
    theme_->addItem(tr("Light"), int(ThemeChoice::light));
    theme_->addItem(tr("Dark"), int(ThemeChoice::dark));
    choose(*theme_, int(readThemeChoice(settings_)));
    units_ =
        addList(form, tr("Units"), "preferredUnits",
                tr("In which areas, lengths and heights are shown and lengths are typed; applies at once"));
    units_->addItem(tr("Metric: metres"), int(UnitSystem::metric));
    units_->addItem(tr("Imperial: feet"), int(UnitSystem::imperial));
    units_->addItem(tr("Metric and imperial"), int(UnitSystem::both));
    choose(*units_, int(readUnits(settings_)));
}

void PreferencesDialog::addUse(QFormLayout& form) {
    const PageSetup setup = readPageSetup(settings_);
    paper_ = addList(form, tr("Paper"), "preferredPaper",
                     tr("Of sheets, until you choose another for one of them"));
    for (const Paper paper : papers)
        paper_->addItem(QString::fromStdString(std::string(nameOf(paper))), int(paper));
    choose(*paper_, int(setup.paper));
    orientation_ = addList(form, tr("Orientation"), "preferredOrientation", tr("Of sheets"));
    orientation_->addItem(tr("Portrait"), 0);
    orientation_->addItem(tr("Landscape"), 1);
    choose(*orientation_, setup.landscape ? 1 : 0);
    start_ = new QCheckBox(tr("Show the start page when Noonmark starts"));
    start_->setObjectName(QStringLiteral("preferredStart"));
    start_->setToolTip(
        tr("Only where no file is opened with the program. Help > Start page shows it at any time"));
    start_->setChecked(readShowStart(settings_));
    form.addRow(start_);
}

// Returns whether all texts have to be written again.
bool PreferencesDialog::saveLooks() {
    const auto language = Language(chosen(*language_));
    const auto units = UnitSystem(chosen(*units_));
    const auto theme = ThemeChoice(chosen(*theme_));
    const bool isOther = language != readLanguage(settings_) || units != readUnits(settings_);
    saveLanguage(language, settings_);
    saveUnits(units, settings_);
    if (theme != readThemeChoice(settings_)) {
        saveThemeChoice(theme, settings_);
        if (auto* now = ApplicationTheme::inUse()) now->choose(theme);
    }
    return isOther;
}

void PreferencesDialog::save() {
    const bool isOther = saveLooks();
    savePageSetup({Paper(chosen(*paper_)), chosen(*orientation_) == 1}, settings_);
    saveShowStart(start_->isChecked(), settings_);
    Q_EMIT paperChosen();
    if (isOther) Q_EMIT textsChanged();
    accept();
}

PreferencesActions::PreferencesActions(QSettings& settings, QWidget& window)
    : settings_(settings),
      window_(window),
      show_(makeAction(this, tr("Pr&eferences..."), QKeySequence(tr("Ctrl+,")),
                       tr("Language, colours, units, paper and start page"))) {
    show_->setMenuRole(QAction::PreferencesRole);
    connect(show_, &QAction::triggered, this, &PreferencesActions::show);
}

void PreferencesActions::show() {
    auto* dialog = new PreferencesDialog(settings_, &window_);
    connect(dialog, &PreferencesDialog::paperChosen, this, &PreferencesActions::paperChosen);
    connect(dialog, &PreferencesDialog::textsChanged, this, &PreferencesActions::textsChanged);
    dialog->open();
}

}  // namespace noonmark
