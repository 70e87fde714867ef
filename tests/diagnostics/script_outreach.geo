// SystemCall "in a comment";
/* Merge "in
   another"; */
a = Sprintf("Exit and Abort in a text");
SystemCall "date > date.txt";
Printf("to the terminal: %g", 1);
Printf("to a file") >> "log.txt";
  Merge
    "other.step";
Field[1] = ExternalProcess; Field[1].CommandLine = "date";
View.Light = 0; View "results" { };
Exit;
