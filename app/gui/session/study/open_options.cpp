#include "app/gui/session/study/open_options.h"

#include <QAbstractItemView>
#include <QAction>
#include <QCheckBox>
#include <QCompleter>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardItemModel>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/massing_preview.h"
#include "core/io/formats/format.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

constexpr int nameRole = Qt::UserRole;
constexpr int listWidth = 460;

QString fieldText(const std::string& utf8) { return QString::fromStdString(utf8); }

// Only layers that are read; all where none is.
std::vector<const ListedLayer*> readLayers(const std::vector<FieldsOfFile>& files) {
    std::vector<const ListedLayer*> layers;
    for (const FieldsOfFile& file : files)
        for (const ListedLayer& layer : file.layers)
            if (layer.isRead) layers.push_back(&layer);
    return layers;
}

QString describeField(const ListedField& field, std::size_t sampled) {
    const QString alias =
        field.alias.empty() ? QString() : QStringLiteral(" (%1)").arg(fieldText(field.alias));
    return fieldText(field.name) + alias + QStringLiteral("   ") +
           localiseNumbers(fieldText(describeValues(field, sampled)));
}

// Numbers come first where numbers are wanted; a field that is read for another purpose stays choosable.
bool isLikely(const ListedField& field, FieldRole role) {
    return role == FieldRole::name ? !field.low.has_value() : field.low.has_value();
}

using Entries = std::vector<std::pair<QString, QString>>;

Entries listEntries(const std::vector<const ListedLayer*>& layers, FieldRole role) {
    Entries likely, others;
    for (const ListedLayer* layer : layers)
        for (const ListedField& field : layer->fields) {
            Entries& list = isLikely(field, role) ? likely : others;
            list.emplace_back(fieldText(field.name), describeField(field, layer->sampled));
        }
    likely.insert(likely.end(), others.begin(), others.end());
    return likely;
}

QString findByName(const std::vector<const ListedLayer*>& layers, FieldRole role) {
    for (const ListedLayer* layer : layers) {
        const auto found = std::ranges::find(layer->fields, std::optional(role), &ListedField::role);
        if (found != layer->fields.end()) return fieldText(found->name);
    }
    return {};
}

}  // namespace

FieldChoices::FieldChoices(QWidget& form) : QObject(&form) {
    const auto line = [&form](const char* name) {
        return form.findChild<QLineEdit*>(QString::fromLatin1(name));
    };
    fields_ = {{line("heightField"), FieldRole::height},
               {line("levelsField"), FieldRole::levels},
               {line("buildingNameField"), FieldRole::name}};
    layer_ = line("layer");
}

void FieldChoices::show(const std::vector<FieldsOfFile>& files) {
    const auto layers = readLayers(files);
    for (const Choosable& field : fields_) {
        if (!field.line) continue;
        addList(*field.line, listEntries(layers, field.role));
        const QString found = findByName(layers, field.role);
        field.line->setPlaceholderText(found.isEmpty() ? tr("none is found by name")
                                                       : tr("found by name: %1").arg(found));
    }
    Entries names;
    for (const FieldsOfFile& file : files)
        for (const ListedLayer& layer : file.layers)
            names.emplace_back(fieldText(layer.name),
                               tr("%1   %2 feature(s)", "", pluralNumber(layer.features))
                                   .arg(fieldText(layer.name), formatCount(layer.features)));
    if (layer_) addList(*layer_, names);
}

// The arrow at the end of the line, and the key Down, open the list.
void FieldChoices::addList(QLineEdit& line, const Entries& entries) {
    auto* model = new QStandardItemModel;
    for (const auto& [name, shown] : entries) {
        auto* item = new QStandardItem(shown);
        item->setData(name, nameRole);
        item->setToolTip(shown);
        model->appendRow(item);
    }
    auto* list = new QCompleter(model, &line);
    model->setParent(list);
    list->setCompletionRole(nameRole);
    list->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    list->popup()->setMinimumWidth(listWidth);
    connect(list, qOverload<const QString&>(&QCompleter::activated), this, &FieldChoices::chosen,
            Qt::QueuedConnection);  // after the line has taken the name
    delete line.completer();
    line.setCompleter(list);
    if (auto* arrow = line.findChild<QAction*>(QStringLiteral("openList"))) delete arrow;
    if (entries.empty()) return;
    QAction* arrow =
        line.addAction(line.style()->standardIcon(QStyle::SP_ArrowDown), QLineEdit::TrailingPosition);
    arrow->setObjectName(QStringLiteral("openList"));
    arrow->setToolTip(tr("Lists the fields with sample values"));
    connect(arrow, &QAction::triggered, list, [list, &line] {
        line.setFocus();  // only a line with the keys takes what is chosen
        list->complete();
    });
}

namespace {

constexpr qsizetype maxNames = 6;
constexpr int pauseMs = 400;  // between an edit and the reading that it causes

QString namesOf(const QStringList& files) {
    QStringList names;
    for (const QString& file : files.first(std::min(files.size(), maxNames)))
        names << QFileInfo(file).fileName();
    if (files.size() > maxNames) names << QObject::tr("and %1 more").arg(files.size() - maxNames);
    return names.join(QLatin1Char('\n'));
}

std::vector<std::filesystem::path> pathsOf(const QStringList& files) {
    std::vector<std::filesystem::path> paths;
    for (const QString& file : files) paths.emplace_back(file.toStdString());
    return paths;
}

}  // namespace

OpenOptions::OpenOptions(QWidget* parent)
    : QDialog(parent),
      names_(new QLabel),
      form_(new ReadingForm),
      choices_(new FieldChoices(*form_)),
      preview_(new MassingPreview),
      pause_(new QTimer(this)) {
    setObjectName(QStringLiteral("openOptions"));
    setWindowTitle(tr("Open with options"));
    names_->setObjectName(QStringLiteral("files"));
    names_->setTextFormat(Qt::PlainText);
    auto* add = new QPushButton(tr("Add terrain or surface model..."));
    add->setObjectName(QStringLiteral("addFiles"));
    add->setAutoDefault(false);  // Enter must trigger Open
    add->setToolTip(
        tr("Reads elevations together with the buildings. Of a surface model and a terrain, "
           "missing heights are the difference."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Open)->setToolTip(tr("Read the files with these settings"));
    auto* side = new QVBoxLayout;
    side->addWidget(names_);
    side->addWidget(add, 0, Qt::AlignLeft);
    side->addWidget(preview_, 1);
    auto* halves = new QHBoxLayout;
    halves->addWidget(form_);
    halves->addLayout(side, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(halves, 1);
    column->addWidget(buttons);
    column->setSizeConstraint(QLayout::SetMinimumSize);
    pause_->setSingleShot(true);
    pause_->setInterval(pauseMs);
    connect(pause_, &QTimer::timeout, this, &OpenOptions::readPreview);
    connect(form_, &ReadingForm::edited, pause_, qOverload<>(&QTimer::start));
    connect(choices_, &FieldChoices::chosen, pause_, qOverload<>(&QTimer::start));
    connect(add, &QPushButton::clicked, this, [this] { addFiles(askForCity(this)); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::finished, this, &OpenOptions::stop);
    connect(this, &QDialog::accepted, this, [this] { Q_EMIT chosen(files_, form_->settings()); });
}

void OpenOptions::ask(const QStringList& files, const ReadSettings& settings) {
    files_ = files;
    form_->show(settings);
    showFiles();
    show();
    raise();
    activateWindow();
}

void OpenOptions::addFiles(const QStringList& files) {
    if (files.isEmpty()) return;
    for (const QString& file : files)
        if (!files_.contains(file)) files_ << file;
    ReadSettings settings = form_->settings();
    settings.heightsFromSurface = true;
    form_->show(settings);
    showFiles();
}

void OpenOptions::showFiles() {
    names_->setText(namesOf(files_));
    names_->setToolTip(files_.join(QLatin1Char('\n')));
    listFields();
    readPreview();
}

// A file that cannot be listed cannot be read either: the preview says why.
void OpenOptions::listFields() {
    using Listed = std::vector<FieldsOfFile>;
    listing_.start<Listed>(
        tr("Listing fields"),
        [files = files_](Progress&, const std::stop_token& stop) -> Result<Listed> {
            Listed listed;
            for (const QString& file : files)
                if (auto layers = listLayers(file.toStdString(), stop))
                    listed.push_back({file.toStdString(), *std::move(layers)});
            return listed;
        },
        [this](const Result<Listed>& listed) { choices_->show(listed.value_or(Listed{})); });
}

void OpenOptions::readPreview() {
    preview_->showWaiting();
    reading_.start<MassingSketch>(
        tr("Reading for the preview"),
        [paths = pathsOf(files_), settings = form_->settings()](
            Progress& progress, const std::stop_token& stop) -> Result<MassingSketch> {
            const auto read = readCity(paths, settings, progress, stop);
            if (!read) return tl::make_unexpected(read.error());
            return sketchMassing(read->city);
        },
        [this](Result<MassingSketch> sketch) { preview_->show(std::move(sketch)); });
}

void OpenOptions::stop() {
    pause_->stop();
    listing_.drop();
    reading_.drop();
}

void OpenOptions::setMiddle(std::optional<LonLat> middle) { form_->setMiddle(middle); }

ReadingForm::ReadingForm(QWidget* parent)
    : QWidget(parent), rows_(new FieldRows(readSettingsFields().rows(), this)) {
    makeFields();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (QGroupBox* group : {makeHeights(), makeData(), makeMeshes()}) column->addWidget(group);
    setMiddle({});
    connect(rows_, &FieldRows::edited, this, &ReadingForm::edited);
}

void ReadingForm::makeFields() {
    anchored_ = new QCheckBox(tr("Origin located at"));
    longitude_ = numberField(-180, 180, 7, 0.001, tr("° east"));
    latitude_ = numberField(-90, 90, 7, 0.001, tr("° north"));
    toMiddle_ = new QPushButton(tr("Middle of the open city"));
    toMiddle_->setAutoDefault(false);  // Enter must trigger Open
    const auto add = [](QWidget* field, const char* name, const QString& tip) {
        field->setObjectName(QString::fromLatin1(name));
        field->setToolTip(tip);
    };
    add(anchored_, "anchored",
        tr("Geographic location of the mesh's origin. Required for a mesh opened alone.\nOff: at the origin "
           "of the city from the other files."));
    add(longitude_, "longitude", tr("Longitude of the mesh's origin, degrees, east positive, -180 to 180"));
    add(latitude_, "latitude", tr("Latitude of the mesh's origin, degrees, north positive, -90 to 90"));
    add(toMiddle_, "toMiddle", tr("Places the mesh's origin at the middle of the open city"));
}

QGroupBox* ReadingForm::makeHeights() {
    auto* group = new QGroupBox(tr("Heights and names"));
    rows_->addRows(*new QFormLayout(group), {"--height-field", "--levels-field", "--building-name-field",
                                             "--height-unit", "--metres-per-level", "--default-height"});
    return group;
}

QGroupBox* ReadingForm::makeData() {
    auto* group = new QGroupBox(tr("Place and choice of data"));
    rows_->addRows(*new QFormLayout(group),
                   {"--crs", "--layer", "--lod", "--far-away", "--terrain-from-bases", "--stand",
                    "--terrain-shows", "--heights-from-surface"});
    return group;
}

QGroupBox* ReadingForm::makeMeshes() {
    auto* group = new QGroupBox(tr("Meshes (%1)").arg(QString::fromStdString(listNames({FileKind::mesh}))));
    auto* form = new QFormLayout(group);
    rows_->addRows(*form, {"--up", "--mesh-unit", "--mesh-north"});
    form->addRow(anchored_, makeAnchor());
    form->addRow(QString(), toMiddle_);
    return group;
}

QWidget* ReadingForm::makeAnchor() {
    auto* place = new QWidget;
    auto* row = new QHBoxLayout(place);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(longitude_, 1);
    row->addWidget(latitude_, 1);
    connect(anchored_, &QCheckBox::toggled, place, &QWidget::setEnabled);
    connect(toMiddle_, &QPushButton::clicked, this, [this] {
        if (middle_) showAnchor(*middle_);
    });
    place->setEnabled(false);
    return place;
}

void ReadingForm::setMiddle(std::optional<LonLat> middle) {
    middle_ = middle;
    toMiddle_->setEnabled(middle_.has_value());
}

void ReadingForm::showAnchor(LonLat place) {
    anchored_->setChecked(true);
    longitude_->setValue(place.lonDeg);
    latitude_->setValue(place.latDeg);
}

ReadSettings ReadingForm::settings() const {
    ReadSettings settings;
    rows_->take(readSettingsFields().of(settings));
    if (anchored_->isChecked()) settings.meshAnchor = LonLat{longitude_->value(), latitude_->value()};
    return settings;
}

void ReadingForm::show(const ReadSettings& settings) {
    rows_->show(readSettingsFields().of(settings));
    showAnchor(settings.meshAnchor.value_or(LonLat{}));
    anchored_->setChecked(settings.meshAnchor.has_value());
}

}  // namespace noonmark
