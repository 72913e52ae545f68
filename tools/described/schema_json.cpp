
#include "scenario_schema.h"
#include "tools/described/scenario_json.h"
#include "tools/files/json_pointer.h"

namespace hyrax {
namespace {

using Object = Json::Object;

Json closed_object(Object properties, Json::Array required = {}) {
  Object schema{{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
  if (!required.empty()) schema.emplace_back("required", std::move(required));
  return schema;
}

Json any_of(Json a, Json b) { return Object{{"anyOf", Json::Array{std::move(a), std::move(b)}}}; }

Json number_schema(const ValueInfo& value, const std::array<Word, 2>& limits) {
  const ValueInfo plain{.name = {}, .type = value.type};
  Object schema{{"type", is_floating(value.type) ? "number" : "integer"}};
  if (limits != range_of(ValueType::float64)) {
    schema.emplace_back("minimum", value_json(plain, limits[0]));
    schema.emplace_back("maximum", value_json(plain, limits[1]));
  }
  return schema;
}

// @param is_limited as of read_value.
Json value_schema(const ValueInfo& value, bool is_limited = true) {
  if (value.type == ValueType::boolean) return Object{{"type", "boolean"}};
  const Json number = number_schema(value, is_limited ? file_limits(value) : range_of(value.type));
  if (value.names.empty()) return number;
  return any_of(Object{{"enum", Json::Array(value.names.begin(), value.names.end())}}, number);
}

Json pair_of(Json item) {
  return Object{{"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", std::move(item)}};
}

Json final_schema(const ValueInfo& value) {
  const Json exact = value_schema(value, false);
  if (value.type == ValueType::boolean) return exact;
  return is_floating(value.type) ? pair_of(exact) : any_of(exact, pair_of(exact));
}

Object properties_of(const std::vector<ValueInfo>& values, const auto& schema_of) {
  Object properties;
  for (const ValueInfo& value : values) properties.emplace_back(value.name, schema_of(value));
  return properties;
}

Json values_schema(const std::vector<ValueInfo>& values) {
  return closed_object(properties_of(values, [](const ValueInfo& value) { return value_schema(value); }));
}

Json action_schema(const ActionInfo& action) {
  const auto schema_of = [](const ValueInfo& argument) { return value_schema(argument); };
  return closed_object(properties_of(action.arguments, schema_of),
                       list_of(action.arguments, [](const ValueInfo& argument) { return argument.name; }));
}

// @param common the paper's core's, of which times and the hitch are the same.
Json event_schema(const Description& description, const Json& common) {
  const Json& members = *common.find("properties");
  std::vector<ValueInfo> settable = description.inputs.values;
  settable.insert(settable.end(), description.state.values.begin(), description.state.values.end());
  Object actions{{"set", values_schema(settable)},
                 {"hitch", *members.find("hitch")},
                 {"hold", closed_object({})},
                 {"go", closed_object({})}};
  for (const ActionInfo& action : description.actions)
    actions.emplace_back(action.name, action_schema(action));
  const auto required = [](std::string_view key) { return Object{{"required", Json::Array{key}}}; };
  const Json one_action = list_of(actions, [&](const auto& action) { return required(action.first); });
  Object properties{{"step", *members.find("step")}, {"at_s", *members.find("at_s")}};
  properties.insert(properties.end(), actions.begin(), actions.end());
  Json schema = closed_object(std::move(properties));
  set_at(schema, "/allOf",
         Json::Array{Object{{"oneOf", Json::Array{required("step"), required("at_s")}}},
                     Object{{"oneOf", one_action}}});
  return schema;
}

Json expect_schema(const Description& description, const Json& common) {
  const Json& members = *common.find("properties");
  Object contacts;
  for (const std::string& contact : description.contacts)
    contacts.emplace_back(contact, Object{{"$ref", "#/$defs/count"}});
  Object properties{{"finite", *members.find("finite")},
                    {"final", closed_object(properties_of(description.state.values, final_schema))},
                    {"contacts", closed_object(std::move(contacts))},
                    {"state_hash", *members.find("state_hash")}};
  if (has_px(description)) properties.emplace_back("at_rest_since_s", *members.find("at_rest_since_s"));
  return closed_object(std::move(properties));
}

}  // namespace

Json schema_json(const Description& description) {
  // What scenarios of all cores share is taken from the schema of the paper's core.
  const Json common = parse_json(kScenarioSchema, "schema");
  const Json& members = *common.find("properties");
  Object properties;
  for (const std::string_view key :
       {"$schema", "format", "name", "description", "clock", "steps", "duration_s", "events", "record"})
    properties.emplace_back(key, *members.find(key));
  properties.emplace_back("core", Object{{"const", description.core}});
  properties.emplace_back("start", values_schema(description.state.values));
  properties.emplace_back("parameters", values_schema(description.parameters.values));
  properties.emplace_back("inputs",
                          closed_object(properties_of(description.inputs.values, [](const ValueInfo& value) {
                            const Json schema = value_schema(value);
                            return any_of(schema, Object{{"type", "array"}, {"items", schema}});
                          })));
  properties.emplace_back("expect", expect_schema(description, *members.find("expect")));
  Object definitions;
  for (const std::string_view key :
       {"dt_s", "steps", "seed", "jitter", "interval", "time", "count", "whole_count"})
    definitions.emplace_back(key, *common.find("$defs")->find(key));
  definitions.emplace_back("event", event_schema(description, *common.find("$defs")->find("event")));
  Object schema{{"$schema", *common.find("$schema")},
                {"$id", "urn:hyrax-scenario:1:" + description.core},
                {"title", "Scenario of the core " + description.core + ", hyrax-scenario/1"},
                {"type", "object"},
                {"required", Json::Array{"format", "clock"}},
                {"additionalProperties", false},
                {"properties", std::move(properties)}};
  for (const std::string_view key : {"if", "then", "else", "dependentSchemas"})
    schema.emplace_back(key, *common.find(key));
  schema.emplace_back("$defs", std::move(definitions));
  return schema;
}

}  // namespace hyrax
