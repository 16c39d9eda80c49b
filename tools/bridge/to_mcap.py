"""Writes messages as JSON into an MCAP file: topics named like the channels, the world's clock as the time."""

import json

from faults import missing

MISSION_TOPIC = "QUARTER_MISSION"
PRIMITIVE = {"float": "number", "double": "number", "string": "string", "boolean": "boolean"}  # the others are integers


def schema_of(generated):
    """The JSON schema of a type that lcm-gen made."""
    properties = {}
    for name, of, sizes in zip(generated.__slots__, generated.__typenames__, generated.__dimensions__):
        schema = {"type": PRIMITIVE.get(of, "integer")}
        for size in reversed(sizes or []):
            schema = {"type": "array", "items": schema, "minItems": size, "maxItems": size}
        properties[name] = schema
    return {"type": "object", "properties": properties, "required": list(properties)}


def encoded(value):
    return json.dumps(value, allow_nan=False, separators=(",", ":")).encode()


class McapSink:
    name = "mcap"

    def __init__(self, path, mission, types, _title):
        try:
            from mcap.writer import Writer
        except ImportError:
            raise missing("mcap") from None
        self.file = open(path, "wb")
        self.writer = Writer(self.file)
        self.writer.start(library="quarter bridge")
        self.types = types
        self.schemas, self.channels, self.counts = {}, {}, {}
        if mission is not None:
            self.put(MISSION_TOPIC, "mission", {"type": "object"}, 0, mission.told)

    def add(self, message):
        """Whether the message went in."""
        self.put(message.channel, message.kind, None, message.utime, message.fields)
        return True

    def put(self, topic, kind, schema, utime, fields):
        if kind not in self.schemas:
            self.schemas[kind] = self.writer.register_schema(
                f"quarter.{kind}", "jsonschema", encoded(schema or schema_of(self.types[kind])))
        if topic not in self.channels:
            self.channels[topic] = self.writer.register_channel(topic, "json", self.schemas[kind])
        self.counts[topic] = self.counts.get(topic, 0) + 1
        self.writer.add_message(self.channels[topic], log_time=1000 * utime, publish_time=1000 * utime,
                                sequence=self.counts[topic] % 2**32, data=encoded(fields))

    def close(self):
        self.writer.finish()
        self.file.close()

    def drop(self):
        self.file.close()
