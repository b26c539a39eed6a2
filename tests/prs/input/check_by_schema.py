"""Tells for each document of a JSON file {schema, documents} whether the schema takes it."""

import json
import sys

from jsonschema import Draft202012Validator

with open(sys.argv[1], encoding="utf-8") as file:
    question = json.load(file)
Draft202012Validator.check_schema(question["schema"])
validator = Draft202012Validator(question["schema"])
for document in question["documents"]:
    print("valid" if validator.is_valid(document) else "invalid")
