#pragma once

#include <QWidget>

#include "core/io/read_city.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLineEdit;
class QPushButton;

namespace noonmark {

/// Fields for ReadSettings: what a file may not state. ReadSettings::frame has no field and stays empty.
class ReadingForm final : public QWidget {
    Q_OBJECT
public:
    explicit ReadingForm(QWidget* parent = nullptr);

    [[nodiscard]] ReadSettings settings() const;
    void show(const ReadSettings& settings);
    void setMiddle(std::optional<LonLat> middle);  ///< of the open city; none: disables the button

private:
    void makeFields();
    QGroupBox* makeHeights();
    QGroupBox* makeData();
    QGroupBox* makeMeshes();
    QWidget* makeAnchor();
    void tell();
    void showAnchor(LonLat place);

    QLineEdit* heightField_;
    QLineEdit* levelsField_;
    QComboBox* heightUnit_;
    QDoubleSpinBox* metresPerLevel_;
    QDoubleSpinBox* defaultHeight_;
    QLineEdit* layer_;
    QLineEdit* crs_;
    QLineEdit* lod_;
    QDoubleSpinBox* farAway_;
    QComboBox* terrainFromBases_;
    QComboBox* stand_;
    QComboBox* terrainShows_;
    QCheckBox* heightsFromSurface_;
    QComboBox* upAxis_;
    QComboBox* meshUnit_;
    QDoubleSpinBox* meshNorth_;
    QCheckBox* anchored_;
    QDoubleSpinBox* longitude_;
    QDoubleSpinBox* latitude_;
    QPushButton* toMiddle_;
    std::optional<LonLat> middle_;
};

}  // namespace noonmark
