#pragma once

// The folder core/describe says what the settings of the program are, each once. A Field (this file) is one
// row for one member of a struct of settings: its key, flag, label, unit, range, default. Interfaces loop
// over the rows: JSON (field_json.h), command lines (command_options.h), checks and comparison
// (field_values.h), options of the command line (app/cli/options/field_options.h) and form rows
// (app/gui/base/widgets/field_rows.h). The tables stand beside the structs: core/sun/period_fields.h.

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/describe/codec.h"

namespace noonmark {

struct KeyedLabel {
    std::string_view key;    ///< "terrain"
    std::string_view label;  ///< for forms, NM_TEXT
};

/// What a field decides, for hashes and comparisons.
enum class SettingRole {
    question,  ///< what is measured: another value is another question
    extra,     ///< what else is computed along with it: the question stays the same
    none,      ///< no result depends on it: names, the memory that the work may take
};

/// How people enter a text.
enum class TextEntry { line, date, timeOfDay, zone };

/// What is written down about a field. Texts are in English; labels and help are marked by NM_TEXT.
struct FieldFacts {
    std::string_view key;         ///< of JSON, with its unit: "step_min"
    std::string_view flag = {};   ///< of the command line: "--step"; "--no-..." of a yes. Empty: none
    std::string_view label = {};  ///< of a form: "Step"
    std::string_view help = {};   ///< one sentence
    std::string_view hint = {};   ///< stands for the value in the help of a flag: "MIN"
    TextEntry entry = TextEntry::line;
    std::string_view unit = {};            ///< "min", "m", "h", "hPa", "C", "deg"; empty: none
    std::optional<ValueRange> range = {};  ///< of a number, or of each in a list; both ends are included
    double shownTimes = 1;  ///< people write and read a number times this: 100 for a share in percent
    /// Stands in an empty text field, or for a number whose least value, its default, states none: "found by
    /// name", "automatic".
    std::string_view whenEmpty = {};
    SettingRole role = SettingRole::question;
    bool hasDefault = true;                       ///< false: a user states it, whatever a new struct holds
    bool restated = false;                        ///< repeat commands state the default too
    std::vector<std::string_view> excludes = {};  ///< flags that cannot stand beside this one
    std::string_view needs = {};                  ///< flag without which this one means nothing
};

/// A row of a table of fields. Its functions take the struct that the table is of.
struct Field : FieldFacts {
    ValueKind kind = ValueKind::text;
    bool isOptional = false;                     ///< may be unset
    std::vector<KeyedLabel> choices{};           ///< of ValueKind::choice
    Value standard{};                            ///< of a new struct
    std::string_view group{};                    ///< JSON object that holds it: "period"; empty: none
    std::function<bool(const void*)> applies{};  ///< empty: always
    std::function<Value(const void*)> get{};
    std::function<Result<void>(void*, const Value&)> set{};  ///< error: a value of another kind or form
};

/// A struct with its fields, as interfaces take it. Refers to both: a temporary only within its expression.
struct Described {
    std::span<const Field> fields;
    const void* object = nullptr;
    [[nodiscard]] bool applies(const Field& field) const { return !field.applies || field.applies(object); }
    [[nodiscard]] Value get(const Field& field) const { return field.get(object); }
};

/// The same to be changed.
struct Editable {
    std::span<const Field> fields;
    void* object = nullptr;
    operator Described() const { return {fields, object}; }  // NOLINT(google-explicit-constructor)
    [[nodiscard]] Result<void> set(const Field& field, const Value& value) const {
        return field.set(object, value);
    }
};

/// Copies the fields with these flags from one object to another of the same table.
void copyFields(const Described& from, const Editable& to, const std::set<std::string, std::less<>>& flags);

/// The error of a value that the field cannot take.
tl::unexpected<Error> refuseValue(const FieldFacts& facts);

/// The flag without its dashes, else the key: where an error lies.
std::string_view nameOf(const FieldFacts& facts);

/// A row of the table of S while it is written down.
template <class S>
class FieldOf {
public:
    explicit FieldOf(Field row) : row_(std::move(row)) {}

    /// Where the field does not apply, files and commands leave it out.
    FieldOf when(bool (*applies)(const S&)) && {
        row_.applies = [applies](const void* object) { return applies(*static_cast<const S*>(object)); };
        return std::move(*this);
    }

    /// The choices of a derived field; unset is one more where its default is unset.
    FieldOf among(std::span<const KeyedLabel> choices) && {
        row_.choices.assign(choices.begin(), choices.end());
        row_.isOptional = row_.standard == Value();
        return std::move(*this);
    }

    [[nodiscard]] const Field& row() const { return row_; }

private:
    Field row_;
};

namespace fields {

/// The row of a member with its codec.
template <class S, class M>
Field makeField(M S::*member, const Codec<M>& codec, FieldFacts facts) {
    Field row{std::move(facts), codec.kind};
    row.get = [member, to = codec.toValue](const void* object) {
        return to(static_cast<const S*>(object)->*member);
    };
    row.set = [member, from = codec.fromValue, named = static_cast<const FieldFacts&>(row)](
                  void* object, const Value& value) -> Result<void> {
        auto read = from(value);
        if (!read && read.error().what.empty()) return refuseValue(named);
        if (!read) return tl::make_unexpected(read.error());
        static_cast<S*>(object)->*member = *std::move(read);
        return {};
    };
    const S standard{};
    row.standard = row.get(&standard);
    return row;
}

template <class S, class M>
Field makeOptionalField(std::optional<M> S::*member, const Codec<M>& codec, FieldFacts facts) {
    Field row = makeField(member, orUnset(codec), std::move(facts));
    row.isOptional = true;
    return row;
}

template <class E>
std::vector<KeyedLabel> listLabels(std::span<const Choice<E>> choices) {
    std::vector<KeyedLabel> list;
    for (const Choice<E>& choice : choices) list.push_back({choice.key, choice.label});
    return list;
}

}  // namespace fields

/// A row for a member that is a number, a text, yes or no, or a list; the second for one that may be unset.
template <class S, class M>
FieldOf<S> field(M S::*member, FieldFacts facts) {
    return FieldOf<S>(fields::makeField(member, codecOf<M>(), std::move(facts)));
}
template <class S, class M>
FieldOf<S> field(std::optional<M> S::*member, FieldFacts facts) {
    return FieldOf<S>(fields::makeOptionalField(member, codecOf<M>(), std::move(facts)));
}

/// A row for a member that is written as text. `parse` returns a Result of it.
template <class S, class M>
FieldOf<S> textField(M S::*member, std::string (*format)(M), Result<M> (*parse)(std::string_view),
                     FieldFacts facts) {
    return FieldOf<S>(fields::makeField(member, textCodec<M>(format, parse), std::move(facts)));
}
template <class S, class M>
FieldOf<S> textField(std::optional<M> S::*member, std::string (*format)(const M&),
                     Result<M> (*parse)(std::string_view), FieldFacts facts) {
    return FieldOf<S>(fields::makeOptionalField(member, textCodec<M>(format, parse), std::move(facts)));
}

/// A row for an enumeration. `choices` in the order of the enumeration, which files of earlier versions
/// count; they outlive the row.
template <class S, class E>
FieldOf<S> choiceField(E S::*member, std::span<const Choice<std::type_identity_t<E>>> choices,
                       FieldFacts facts) {
    Field row = fields::makeField(member, choiceCodec<E>(choices), std::move(facts));
    row.choices = fields::listLabels(choices);
    return FieldOf<S>(std::move(row));
}
template <class S, class E>
FieldOf<S> choiceField(std::optional<E> S::*member, std::span<const Choice<std::type_identity_t<E>>> choices,
                       FieldFacts facts) {
    Field row = fields::makeOptionalField(member, choiceCodec<E>(choices), std::move(facts));
    row.choices = fields::listLabels(choices);
    return FieldOf<S>(std::move(row));
}

/// A row for what no single member holds. `get` and `set` take the struct.
template <class S>
FieldOf<S> derivedField(ValueKind kind, Value (*get)(const S&), Result<void> (*set)(S&, const Value&),
                        FieldFacts facts) {
    Field row{std::move(facts), kind};
    row.get = [get](const void* object) { return get(*static_cast<const S*>(object)); };
    row.set = [set](void* object, const Value& value) { return set(*static_cast<S*>(object), value); };
    row.standard = get(S{});
    return FieldOf<S>(std::move(row));
}

/// The fields of S, in the order in which interfaces state them. Keys are unique within their group, flags in
/// the table.
template <class S>
class Fields {
public:
    Fields(std::initializer_list<FieldOf<S>> rows) {
        for (const FieldOf<S>& row : rows) rows_.push_back(row.row());
    }

    /// Appends the fields of a member that is a struct itself, in JSON inside the object `group`; empty:
    /// beside the others. They apply where `when` says so, too.
    template <class M>
    Fields embed(M S::*member, const Fields<M>& fields, std::string_view group = {},
                 bool (*when)(const S&) = nullptr) && {
        const S standard{};
        for (Field row : fields.rows()) {
            row.get = [member, get = row.get](const void* object) {
                return get(&(static_cast<const S*>(object)->*member));
            };
            row.set = [member, set = row.set](void* object, const Value& value) {
                return set(&(static_cast<S*>(object)->*member), value);
            };
            row.applies = [member, when, applies = row.applies](const void* object) {
                const S& whole = *static_cast<const S*>(object);
                return (!when || when(whole)) && (!applies || applies(&(whole.*member)));
            };
            if (!group.empty()) row.group = group;
            row.standard = row.get(&standard);
            rows_.push_back(std::move(row));
        }
        return std::move(*this);
    }

    /// Appends the rows of another table of the same struct.
    Fields with(const Fields& others) && {
        rows_.insert(rows_.end(), others.rows_.begin(), others.rows_.end());
        return std::move(*this);
    }

    [[nodiscard]] std::span<const Field> rows() const { return rows_; }
    [[nodiscard]] Described of(const S& object) const { return {rows_, &object}; }
    [[nodiscard]] Editable of(S& object) const { return {rows_, &object}; }

private:
    std::vector<Field> rows_;
};

}  // namespace noonmark
