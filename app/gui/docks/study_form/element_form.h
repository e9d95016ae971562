#pragma once

#include <QWidget>

#include "core/study/elements/place_elements.h"

class QCheckBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace noonmark {

class FaceForm;
class FieldRows;
class LineForm;
class PointListForm;

/// Where points lie: of which buildings' facades, on which windows of a file, how high a plane is, on which
/// lines, or a list of them.
class ElementForm final : public QWidget {
    Q_OBJECT
public:
    /// A rule states itself how high above a floor its windows are, and is about the whole city.
    enum class Use { study, rule };
    explicit ElementForm(Use use = Use::study, QWidget* parent = nullptr);

    void show(const ElementSettings& settings);  ///< without a signal
    void setBuilding(const QString& id);         ///< the selected building; empty: none
    void setNames(const QStringList& lots, const QStringList& places);  ///< of the project, to choose from
    [[nodiscard]] const ElementSettings& settings() const { return settings_; }
    [[nodiscard]] FaceForm& faces() { return *faces_; }
    [[nodiscard]] PointListForm& list() { return *list_; }

Q_SIGNALS:
    void edited(noonmark::ElementSettings settings, QString field);  ///< the name of the field

private:
    void makeFields();
    QWidget* makeBuildings();
    QWidget* makeFile();
    void placeFields();
    void connectFields();
    void connectParts();
    void browse();
    void toggleBuilding();
    void showRows();
    /// Whether the field with this flag means something for the places that are chosen.
    [[nodiscard]] bool applies(std::string_view flag) const;
    void showButton();

    Use use_;
    ElementSettings settings_;
    QString building_;
    QLineEdit* buildings_;  ///< ids or names with commas; empty: all of the region
    QPushButton* selected_;
    QCheckBox* proposed_;
    FaceForm* faces_;
    LineForm* lines_;
    PointListForm* list_;
    QLineEdit* file_;
    QPushButton* browse_;
    QFormLayout* form_;
    FieldRows* rows_;
};

}  // namespace noonmark
