#pragma once

#include <QObject>
#include <vector>

#include "core/io/footprints/list_fields.h"

class QLineEdit;
class QWidget;

namespace noonmark {

/// The layers of one file.
struct FieldsOfFile {
    std::string file;
    std::vector<ListedLayer> layers;
};

/// Lists behind the text fields of a form that name a layer or a field: each entry shows sample values. The
/// names can still be typed.
class FieldChoices final : public QObject {
    Q_OBJECT
public:
    /// `form` has the text fields layer, heightField, levelsField and buildingNameField, and owns this
    /// object.
    explicit FieldChoices(QWidget& form);

    void show(const std::vector<FieldsOfFile>& files);

Q_SIGNALS:
    void chosen();  ///< an entry of a list

private:
    struct Choosable {
        QLineEdit* line;
        FieldRole role;
    };
    void addList(QLineEdit& line, const std::vector<std::pair<QString, QString>>& entries);
    std::vector<Choosable> fields_;
    QLineEdit* layer_;
};

}  // namespace noonmark
